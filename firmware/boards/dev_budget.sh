# The verb budget of ./dev. Sourced by ./dev at the repository's root.
# shellcheck shell=sh

# budget [--accept] [--page] [BOARD…]: the images' reports in build/budget, held to the limits beside each board.
budget() {
  accept=
  page=
  while [ $# -gt 0 ]; do
    case "$1" in
      --accept) accept=--accept ;;
      --page) page=yes ;;
      *) break ;;
    esac
    shift
  done
  for board in "$@"; do check_board "$board"; done
  # shellcheck disable=SC2046  # a list of names
  [ $# -gt 0 ] || set -- $(board_names)
  need_firmware_tools
  say "building the host tool"
  build host spanline
  over=0
  for board in "$@"; do
    say "$board"
    build_board "$board"
    sh firmware/boards/budget.sh build/host/spanline "build/firmware/$board" "$board" build/budget $accept || over=1
  done
  echo "reports: build/budget/BOARD-DEMO.html (.json .txt)"
  [ -z "$page" ] || budget_page
  return "$over"
}

# Writes the table of docs/budgets.md anew.
budget_page() {
  reports=
  for board in $(board_names); do
    for demo in $(build/host/spanline demo --list); do
      report=build/budget/$board-$demo.json
      [ ! -f "$report" ] || reports="$reports $report"  # a board may have no room for a demo
    done
  done
  # shellcheck disable=SC2086  # a list of files
  build/host/spanline budget-table $reports --out build/budget/table.md
  awk '
    /^<!-- measured -->/ { print; print ""; while ((getline line < "build/budget/table.md") > 0) print line; print ""; inside = 1 }
    /^<!-- end -->/ { inside = 0 }
    !inside || /^<!-- end -->/ { if (!/^<!-- measured -->/) print }' docs/budgets.md > build/budget/page.md
  mv build/budget/page.md docs/budgets.md
  echo "docs/budgets.md"
}
