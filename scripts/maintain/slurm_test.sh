#!/usr/bin/env bash
# slurm_test.sh: tests examples/farm on a real one-machine Slurm cluster: submits the array and the
# dependent encode job, kills the process of one task midway and requeues it, and compares the
# video's decoded frames and every frame's digest with those of a single run. Needs root and
# Debian's slurmctld slurmd slurm-client munge; takes some minutes.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
scripts/maintain/build.sh release twrench
export TWRENCH=$PWD/build/release/bin/twrench
farm=$PWD/examples/farm
folder=$(mktemp -d)
chmod 755 "$folder"
daemons=()
stop() {
  ((${#daemons[@]} == 0)) || kill "${daemons[@]}" 2>/dev/null || true
  wait || true
  rm -rf "$folder"
}
trap stop EXIT
say() { echo "$(date +%T) $*"; }
fail() {
  echo "twrench: error: slurm_test: $*" >&2
  cat "$folder"/*.log >&2 || true
  exit 1
}
for _ in slurmctld slurmd sbatch munged; do
  command -v "$_" >/dev/null || fail "no $_: apt-get install slurmctld slurmd slurm-client munge"
done

cd "$folder"
host=$(hostname -s)
mkdir state spool
cat >slurm.conf <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
AuthType=auth/munge
# A requeued job waits until its credentials have expired.
AuthInfo=cred_expire=5
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmctldPidFile=$folder/ctld.pid
SlurmdPidFile=$folder/d.pid
SlurmctldLogFile=$folder/ctld.log
SlurmdLogFile=$folder/d.log
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$folder/slurm.conf
mkdir -p /run/munge && chown munge: /run/munge
if ! pgrep -x munged >/dev/null; then
  runuser -u munge -- munged --foreground &
  daemons+=($!)
fi
slurmctld -D &
daemons+=($!)
slurmd -D &
daemons+=($!)
for ((i = 0; i < 60; ++i)); do
  [[ $(sinfo --noheader --format=%T 2>/dev/null) == idle ]] && break
  sleep 0.5
done
say "Slurm $(sinfo --version | cut -d ' ' -f 2): $(sinfo --noheader)"

film=(dzhanibekov --size 320x180 --fps 15 --speed 6 --duration 96) # 240 frames
"$TWRENCH" render "${film[@]}" --frames-dir single -o single.mp4 --progress none

array=$(sbatch --parsable --array=1-4 "$farm/render.slurm" "${film[@]}" --frames-dir "$folder/f")
encode=$(sbatch --parsable --dependency=afterok:"$array" "$farm/encode.slurm" "$folder/f" -o "$folder/film.mp4")
say "submitted the array $array of 4 shards, and $encode, which depends on it"

# Frame 60 is the second shard's first.
for ((i = 0; i < 600; ++i)); do
  [[ -e f/frame_000065.png ]] && break
  sleep 0.1
done
scontrol requeue "${array}_2"
say "requeued ${array}_2 when the folder had $(find f -name 'frame_*.png' | wc -l) frames"
for ((i = 0; i < 1200; ++i)); do
  [[ -e film.mp4 ]] && break
  sleep 0.25
done
squeue --noheader
[[ -e film.mp4 ]] || fail "no video"
say "the video is complete; the second shard's log:"
tail -n 4 "twrench-${array}_2.log"

sums() { (cd "$1" && sha256sum frame_*.png); }
cmp <(sums single) <(sums f) || fail "frames differ"
decoded() { ffmpeg -v error -i "$1" -f framemd5 -; }
cmp <(decoded single.mp4) <(decoded film.mp4) || fail "the video differs"
say "240 frames have the digests of a single run's, and the video decodes to the same frames"
