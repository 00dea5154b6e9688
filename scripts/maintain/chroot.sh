# shellcheck shell=bash
# Bare installations of Debian, and commands in them. Other scripts source this file after common.sh.

mirror=${DEBIAN_MIRROR:-http://deb.debian.org/debian}
place=$PWD/build/distros # of installations, logs and downloaded packages

# reason_against_roots: prints why no installation can be made here, or nothing if one can.
reason_against_roots() {
  if ((EUID != 0)); then
    echo "only root can make an installation of Debian"
  elif ! unshare --mount --pid --fork mount -t tmpfs tmpfs /mnt 2>/dev/null; then
    echo "mounting is not permitted here"
  fi
}

# The process that isolated() runs, while it runs.
isolated_process=''
# A copy of the standard error of this script, for use while a command logs its own.
exec {own_errors}>&2

# isolated COMMAND...: runs the command in separate namespaces for mounts and processes. The
# namespaces end with the command and with this script, however it ends, so that nothing stays
# mounted or running.
isolated() {
  local status=0
  # bash starts background processes with these signals ignored, which tests of signals would inherit.
  setpriv --pdeathsig KILL unshare --mount --pid --fork --kill-child \
    env --default-signal=INT,QUIT "$@" </dev/null &
  isolated_process=$!
  wait "$isolated_process" || status=$?
  isolated_process=''
  return "$status"
}

stop_isolated() {
  trap - INT TERM HUP
  if [[ $isolated_process ]]; then
    kill -KILL "$isolated_process" 2>/dev/null || true
    wait "$isolated_process" 2>/dev/null || true
  fi
  say "interrupted: nothing is left running or mounted; the next run starts again" 2>&"$own_errors"
  exit 130
}
trap stop_isolated INT TERM HUP

# make_root ROOT SUITE: creates a bare installation.
make_root() {
  local reason
  mkdir -p "$place/packages" 2>/dev/null || die "$place cannot be created" \
    "is the disk full, or is $PWD read-only?"
  rm -rf --one-file-system "$1"
  if ! isolated debootstrap --variant=minbase --cache-dir="$place/packages" "$2" "$1" "$mirror" \
    >"$1.log" 2>&1; then
    reason=$(grep -m 1 -hE 'No space left' "$1.log" "$1/debootstrap/debootstrap.log" 2>/dev/null ||
      grep -E '^[EW]: ' "$1.log" | tail -n 1 || tail -n 1 "$1.log")
    die "debootstrap cannot install $2: ${reason:-no message}" \
      "check the network and the free disk space (3 GB); DEBIAN_MIRROR names another mirror" \
      "the full log is $1.log"
  fi
  cp /etc/resolv.conf "$1/etc/resolv.conf"
  # A mirror that is a few days behind still serves its packages.
  echo 'Acquire::Check-Valid-Until "false";' >"$1/etc/apt/apt.conf.d/90mirror"
  # The installation need not survive a power cut.
  echo force-unsafe-io >"$1/etc/dpkg/dpkg.cfg.d/90speed"
  # As on any real system. Otherwise netbase would write the file and leave it behind.
  echo '127.0.0.1 localhost' >"$1/etc/hosts"
  chroot "$1" useradd --create-home --shell /bin/bash someone
}

# put_sources ROOT: copies the committed sources to /home/someone/twrench.
put_sources() {
  mkdir "$1/home/someone/twrench"
  git archive HEAD | tar --extract --directory "$1/home/someone/twrench"
}

# inside ROOT USER COMMAND: runs the command in the source folder. The installation is the root of a
# mount namespace, not only of a process, so that the tests can create their own namespaces.
inside() {
  # The shell must not be replaced by su: executing a program that sets user IDs would clear the
  # signal with which --kill-child ends it.
  ROOT=$1 AS=$2 COMMAND=$3 isolated bash -euc '
    mount --bind "$ROOT" "$ROOT"
    mount --rbind /dev "$ROOT/dev"
    mount -t proc proc "$ROOT/proc"
    mount -t sysfs -o ro sysfs "$ROOT/sys"
    mkdir -p "$ROOT/.before"
    cd "$ROOT"
    pivot_root . .before
    umount --lazy /.before
    env -i TERM=dumb LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      su --shell /bin/bash - "$AS" -c "cd /home/someone/twrench && $COMMAND"
    exit'
}
