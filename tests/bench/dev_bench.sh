# The verb `bench` of ./dev, which reads this file.

bench_usage() {
  echo "usage: ./dev bench [--pages | --scene F.json [--cpu m0plus|m3|m4] [--shading flat|gouraud] [--memory BYTES]]" >&2
  exit 2
}

bench() {
  pages=
  [ "${1:-}" != --pages ] || { pages=yes; shift; }
  scene= memory= cpus="m0plus m3 m4" shadings="flat gouraud"
  while [ $# -ge 2 ]; do
    case "$1" in
      --scene) scene=$2 ;;
      --cpu) cpus=$2 ;;
      --shading) shadings=$2 ;;
      --memory) memory=$2 ;;
      *) break ;;
    esac
    shift 2
  done
  [ $# -eq 0 ] || { echo "dev bench: what is \"$1\"?" >&2; bench_usage; }
  for cpu in $cpus; do
    case "$cpu" in m0plus | m3 | m4) ;; *) echo "dev bench: --cpu is m0plus, m3 or m4, not \"$cpu\"" >&2; exit 2 ;; esac
  done
  for shading in $shadings; do
    case "$shading" in flat | gouraud) ;; *) echo "dev bench: --shading is flat or gouraud, not \"$shading\"" >&2; exit 2 ;; esac
  done
  need_host_tools
  need_cross_tools
  need libunicorn-dev libcapstone-dev libelf-dev libbenchmark-dev
  say "building the counting tool"
  build host spanline spanline-frames
  say "frames, counted"
  [ -n "$scene" ] && set -- "$scene${memory:+@$memory}" || set -- assets/scenes/S1.json assets/scenes/S3.json assets/scenes/S4.json
  sh tests/bench/frames.sh . build/bench build/host/spanline-frames "$cpus" "$shadings" "$@"
  echo "$(pwd)/build/bench/frames.json"
  [ -z "$scene" ] || return 0
  if [ -n "$pages" ]; then
    say "docs/performance.md"
    sh tests/bench/performance_page.sh . build/bench build/host docs/performance.md
    say "what budgets' sweep expects of frames"
    sh tests/bench/prices.sh . build/bench build/host/spanline-frames
    return
  fi
  say "pieces, on this machine"
  want libpolyclipping-dev
  build host spanline_bench
  build/host/tests/bench/spanline_bench --benchmark_counters_tabular=true
  say "points computed for a pixel, beside older ways"
  build host spanline-redundancy
  build/host/spanline-redundancy build/bench/redundancy.md
  cat build/bench/redundancy.md
  grep -q 'spanline_area_bench' build/host/build.ninja || return 0
  say "the clipper beside libpolyclipping"
  build host spanline_area_bench
  build/host/tests/bench/spanline_area_bench
}
