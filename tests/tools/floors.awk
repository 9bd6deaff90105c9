# SPDX-License-Identifier: BSD-3-Clause
# Every floor only looks down, and no header grows too long. Run inside include/pendular with the headers' names.
BEGIN {
  length_limit = 400
  floors_0_to_2 = "core law laplace_young liquid contact space"
  floors_0_to_3 = floors_0_to_2 " boundary motion observe"
  may_include("core", "core")
  may_include("law", "core law")
  may_include("laplace_young", "core law laplace_young")
  may_include("liquid", "core law liquid")
  may_include("contact", "core law liquid contact space")
  may_include("space", "core space")
  may_include("boundary", floors_0_to_2 " boundary")
  may_include("motion", floors_0_to_2 " motion")
  may_include("observe", floors_0_to_3)
  may_include("scene_state.hpp", floors_0_to_3)
  may_include("system.hpp", floors_0_to_3 " scene_state.hpp")
  may_include("parts.hpp", floors_0_to_3 " scene_state.hpp system.hpp")
  may_include("scene", floors_0_to_3 " system.hpp scene io")
  may_include("io", floors_0_to_3 " io")
  may_include("lammps", floors_0_to_3 " lammps")
  may_include("testing", floors_0_to_3 " testing")
  may_include("pendular.hpp", floors_0_to_3 " system.hpp parts.hpp scene io")
  known["version.hpp"] = 1
}

function may_include(room, list,   names, count, i) {
  known[room] = 1
  allowed[room, "version.hpp"] = 1
  count = split(list, names, " ")
  for (i = 1; i <= count; ++i) allowed[room, names[i]] = 1
}

function complain(what) {
  printf "%s:%d: %s\n", FILENAME, FNR, what
  broken = 1
}

function included() {
  match($0, /[<"][^>"]*/)
  return substr($0, RSTART + 1, RLENGTH - 1)
}

function check_own(path,   parts) {
  split(path, parts, "/")
  if (!((room, parts[2]) in allowed)) complain(room " may not include " path)
}

function check_foreign(path) {
  if (path ~ /^range\// && room ~ /^(core|law|liquid|contact|space)$/) complain("range-v3 has no place in " room)
  if (path ~ /^catch2\//) complain("Catch2 has no place in a header for users")
  if (path == "execution") complain("<execution> does not link without TBB")
}

FNR == 1 {
  split(FILENAME, parts, "/")
  room = parts[1]
  if (!(room in known)) complain("room " room " stands on no floor: give it one in floors.awk")
}
FNR == length_limit + 1 { complain("longer than " length_limit " lines") }
/^[ \t]*#[ \t]*include[ \t]*"/ { complain("write #include <pendular/...>") }
/^[ \t]*#[ \t]*include[ \t]*</ { path = included(); if (path ~ /^pendular\//) check_own(path); else check_foreign(path) }

END { exit broken }
