# Balls of one shape and any number of triangles, for scripts that count frames; they read this file.

# ball RINGS FOLDER: a ball of as many rings and twice as many sectors, and FOLDER/ballRINGS.json that shows it.
ball() {
  awk -v rings="$1" 'BEGIN {
    pi = atan2(0, -1); sectors = 2 * rings
    print "v 0 1 0"
    for (i = 1; i < rings; ++i) for (k = 0; k < sectors; ++k) {
      a = pi * i / rings; b = 2 * pi * k / sectors
      printf "v %.6f %.6f %.6f\n", sin(a) * cos(b), cos(a), -sin(a) * sin(b)
    }
    print "v 0 -1 0"
    last = 2 + (rings - 1) * sectors
    for (k = 0; k < sectors; ++k) {
      next_k = (k + 1) % sectors
      print "f", 1, 2 + k, 2 + next_k
      for (i = 0; i + 2 < rings; ++i) {
        p = 2 + i * sectors + k; q = 2 + i * sectors + next_k
        print "f", p, p + sectors, q
        print "f", q, p + sectors, q + sectors
      }
      print "f", last, 2 + (rings - 2) * sectors + next_k, 2 + (rings - 2) * sectors + k
    }
  }' > "$2/ball$1.obj"
  printf '{ "size": [320, 240], "camera": { "eye": [0, 0.9, 3], "target": [0, 0, 0], "fov": 45, "near": 1, "far": 9 },\n' > "$2/ball$1.json"
  printf '  "meshes": [ { "name": "ball", "obj": "ball%s.obj" } ], "instances": [ { "mesh": "ball" } ] }\n' "$1" >> "$2/ball$1.json"
}
