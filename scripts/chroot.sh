# shellcheck shell=bash
# For the scripts beside it, which source it: bare installations of Debian, and commands in them.

mirror=${DEBIAN_MIRROR:-http://deb.debian.org/debian}
place=$PWD/build/distros # of installations, logs and downloaded packages
mkdir -p "$place/packages"

# make_root ROOT SUITE: creates a bare installation.
make_root() {
  rm -rf --one-file-system "$1"
  debootstrap --variant=minbase --cache-dir="$place/packages" "$2" "$1" "$mirror" \
    >"$1.log" 2>&1 || die "debootstrap $2 failed: $(tail -n 1 "$1.log")" "all it said is in $1.log"
  cp /etc/resolv.conf "$1/etc/resolv.conf"
  # A mirror that is a few days behind still serves its packages.
  echo 'Acquire::Check-Valid-Until "false";' >"$1/etc/apt/apt.conf.d/90mirror"
  # It need not survive a power cut.
  echo force-unsafe-io >"$1/etc/dpkg/dpkg.cfg.d/90speed"
  # As on any real system: netbase would write it, and leave it.
  echo '127.0.0.1 localhost' >"$1/etc/hosts"
  chroot "$1" useradd --create-home --shell /bin/bash someone
}

# put_sources ROOT: copies the committed sources to /home/someone/twrench.
put_sources() {
  mkdir "$1/home/someone/twrench"
  git archive HEAD | tar --extract --directory "$1/home/someone/twrench"
}

# inside ROOT USER COMMAND: runs the command in the source folder. The installation is the root of a
# mount namespace, not only of a process, so that the tests can create namespaces of their own;
# processes left running and mounts end with it.
inside() {
  ROOT=$1 AS=$2 COMMAND=$3 unshare --mount --pid --fork bash -euc '
    mount --bind "$ROOT" "$ROOT"
    mount --rbind /dev "$ROOT/dev"
    mount -t proc proc "$ROOT/proc"
    mount -t sysfs -o ro sysfs "$ROOT/sys"
    mkdir -p "$ROOT/.before"
    cd "$ROOT"
    pivot_root . .before
    umount --lazy /.before
    exec env -i TERM=dumb LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      su --shell /bin/bash - "$AS" -c "cd /home/someone/twrench && $COMMAND"' </dev/null
}
