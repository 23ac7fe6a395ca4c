# What is done on the host, by its sh: host.sh COMMAND ARGUMENTS, started by host.py.
#
# A machine's folder there:
#   turnbuckle -> current/turnbuckle     what is started; the name never changes
#   current -> .switch.XXXXXX            one rename of this link changes both of the next
#   .switch.XXXXXX/turnbuckle, previous  the program in use, the one before
#   turnbuckle-SHA256                    programs
#
# An answer is lines of a key and a value, after a first one that ends what the user's shell may say
# when it starts. "refused REASON WORDS" is the last line where something cannot be done.
set -eu
umask 022
export LC_ALL=C
unset CDPATH

refuse() { # REASON WORDS...
  set -f
  echo refused $* # in one line, whatever the words hold
  exit 1
}

hash_of() { # FILE
  sha256sum <"$1" | cut -c 1-64
}

identity_in() { # FILE: read, not run: it may be of anybody
  tr -c ' -~' '\n' <"$1" | sed -n 's/^.*@(#)turnbuckle //p' | head -n 1
}

tell() { # KEY FILE: SHA256 and identity of a program that is there
  if [ -f "$2" ]; then echo "$1 $(hash_of "$2") $(identity_in "$2")"; fi
}

linked() { # turnbuckle|previous: the program that current has under this name, or nothing
  if [ -L "current/$1" ]; then basename "$(readlink "current/$1")"; fi
}

lock() { # until the end; others wait
  (: >>.lock) 2>/dev/null || refuse permission "$PWD/.lock"
  exec 9>>.lock
  flock -w 60 9 || refuse busy
}

ask() { # FOLDER
  for tool in sha256sum flock timeout mktemp readlink awk sed find; do
    command -v "$tool" >/dev/null || refuse tool "$tool"
  done
  echo "machine $(uname -m)"
  at=$1
  until [ -d "$at" ]; do at=$(dirname "$at"); done
  if ! [ -w "$at" ] || ! [ -x "$at" ]; then refuse permission "$at"; fi
  echo "free $(df -Pk "$at" | awk 'END { print $4 }')"
  tell now "$1/turnbuckle"
}

receive() { # FOLDER SHA256 IDENTITY; the program comes on the standard input
  words=$(mkdir -p "$1" 2>&1) || refuse permission "$words"
  cd "$1"
  find . -maxdepth 1 -name '.copy.*' -mmin +60 -exec rm -f {} + # cut off long ago
  copy=$(mktemp .copy.XXXXXX 2>&1) || refuse permission "$copy"
  trap 'rm -f "$copy"' EXIT
  trap 'exit 1' HUP INT PIPE TERM
  words=$(timeout 600 cat 2>&1 >"$copy") || refuse write "$words"
  [ "$(hash_of "$copy")" = "$2" ] || refuse changed
  chmod 755 "$copy"
  words=$(timeout 60 "./$copy" --version 2>&1) || refuse start "$words"
  [ "$words" = "$3" ] || refuse start "$words"
  timeout 60 sync "$copy" || refuse write sync # on the disk, before a link leads there
  lock
  tell before turnbuckle
  old=$(linked turnbuckle)
  if [ -f turnbuckle ] && ! [ -L turnbuckle ]; then # put there by hand: it is kept like ours
    old=turnbuckle-$(hash_of turnbuckle)
    ln -f turnbuckle "$old"
  fi
  mv -f "$copy" "turnbuckle-$2"
  if [ "$old" = "turnbuckle-$2" ]; then old=$(linked previous); fi
  switch "turnbuckle-$2" "$old"
}

rollback() { # FOLDER
  cd "$1" 2>/dev/null || refuse previous
  lock
  tell before turnbuckle
  new=$(linked previous)
  if [ -z "$new" ] || ! [ -f "$new" ]; then refuse previous; fi
  [ "turnbuckle-$(hash_of "$new")" = "$new" ] || refuse damaged "$PWD/$new"
  switch "$new" "$(linked turnbuckle)"
}

switch() { # NEW OLD: programs of this folder; OLD may be nothing
  fresh=$(mktemp -d .switch.XXXXXX)
  chmod 755 "$fresh"
  ln -s "../$1" "$fresh/turnbuckle"
  if [ -n "$2" ]; then ln -s "../$2" "$fresh/previous"; fi
  replace current "$fresh"
  replace turnbuckle current/turnbuckle
  clear_away
  tell now turnbuckle
  tell previous current/previous
}

replace() { # LINK TARGET
  ln -sfn "$2" ".link.$1"
  mv -fT ".link.$1" "$1"
}

clear_away() { # what no link needs any more; a program that runs from it goes on
  for each in turnbuckle-* .switch.*; do
    case $each in
      "$(linked turnbuckle)" | "$(linked previous)" | "$(readlink current)") ;;
      .switch.*) rm -rf "$each" ;;
      *) if [ ${#each} = 75 ]; then rm -f "$each"; fi ;; # with a whole hash: others are the user's
    esac
  done
}

unit() { # FOLDER NAME; the unit comes on the standard input, and stays in the folder too
  fresh=$1/turnbuckle@.service
  file=/etc/systemd/system/turnbuckle@.service
  cat >"$fresh"
  [ -d "$(dirname "$file")" ] || refuse systemd
  as_root=
  if [ "$(id -u)" != 0 ]; then
    as_root="sudo -n"
    timeout 10 $as_root true 2>/dev/null || refuse sudo "$fresh"
  fi
  if ! [ -f "$file" ]; then
    echo "unit installed"
  elif [ "$(hash_of "$file")" = "$(hash_of "$fresh")" ]; then
    echo "unit same"
  else
    $as_root cp -p "$file" "$file.before"
    echo "unit replaced"
  fi
  $as_root install -m 644 "$fresh" "$file.new"
  $as_root mv -f "$file.new" "$file"
  if [ -d /run/systemd/system ]; then
    timeout 30 $as_root systemctl daemon-reload || refuse reload
  else
    echo "systemd absent"
  fi
  if ! [ -f "/etc/turnbuckle/$2.conf" ]; then echo "conf missing"; fi
}

echo "turnbuckle answers"
"$@"
