# usage: awk -f names.awk FILE...
# Functions start in the first column, as clang-format formats them.

FNR == 1 {
  split(FILENAME, parts, "/")
  room = parts[2]
  is_helper = 0
}
/^namespace \{$/ { is_helper = 1 }
/^}  \/\/ namespace$/ { is_helper = 0 }

/^[A-Za-z_[][^=(]*[ *&][a-z_0-9]+\(/ && !/^(return|using|static_assert|INSTANTIATE)/ {
  name = $0
  sub(/\(.*/, "", name)
  sub(/.*[ *&]/, "", name)
  ++count
  rooms[count] = room
  names[count] = name
  helper[count] = is_helper && FILENAME ~ /\.cpp$/
  place[count] = FILENAME ":" FNR
  file[count] = FILENAME
  key = room " " name
  if (!(key in first)) first[key] = FILENAME
  else if (first[key] != FILENAME) other[key] = FILENAME
}

END {
  for (i = 1; i <= count; ++i) {
    key = rooms[i] " " names[i]
    if (!helper[i] || !(key in other)) continue
    printf "%s: the helper '%s' has the name of a function in %s; give it one of its own\n", place[i], names[i],
      first[key] == file[i] ? other[key] : first[key]
  }
}
