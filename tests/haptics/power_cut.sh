#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures how much of an attempt a power cut leaves. An attempt is drilled on a small disk of its own (ext4 in a file).
# At random moments the file is cloned: the clone has everything that has reached the disk and nothing that the kernel
# still buffers. The clone is then mounted and searched as after a power cut. Needs root, loop devices and XFS, whose
# clones are atomic.
#   tests/haptics/power_cut.sh [CUTS]
set -euo pipefail

cuts=${1:-100}
cuts_a_life=10
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
victim=$root/build/release/tests/haptics_tst_kills
[[ -x $victim ]] || {
    echo "power_cut: build the tests first (./dev test fast)." >&2
    exit 2
}

place=$(mktemp -d)
outer=$place/outer
desk=$place/desk
after=$place/after
life=
end_life() {
    [[ -n $life ]] || return 0
    kill -KILL "$life" 2>/dev/null || true
    wait "$life" 2>/dev/null || true
    life=
}
tidy() {
    end_life
    umount -q "$after" 2>/dev/null || true
    umount -q "$desk" 2>/dev/null || true
    umount -q "$outer" 2>/dev/null || true
    rm -rf "$place"
}
trap tidy EXIT

mkdir "$outer" "$desk" "$after"
truncate -s 400M "$place/outer.img"
mkfs.xfs -q -m reflink=1 "$place/outer.img"
mount -o loop "$place/outer.img" "$outer"

new_disk() {
    umount -q "$desk" 2>/dev/null || true
    rm -f "$outer/disk.img"
    truncate -s 32M "$outer/disk.img"
    mkfs.ext4 -q "$outer/disk.img"
    mount -o loop "$outer/disk.img" "$desk"
}

for ((cut = 0; cut < cuts; ++cut)); do
    if ((cut % cuts_a_life == 0)); then
        end_life
        new_disk
        "$victim" --victim "$desk/journals" "$cut" >"$place/said" &
        life=$!
    fi
    sleep "$(printf '0.%03d' $((RANDOM % 700 + 50)))"
    cp "$place/said" "$place/before"
    cp --reflink=always "$outer/disk.img" "$outer/cut.img"
    cp "$place/said" "$place/after_cut"
    mount -o loop "$outer/cut.img" "$after"
    "$victim" --found "$after/journals" "$place/before" "$place/after_cut" | tee -a "$place/results"
    umount "$after"
    rm "$outer/cut.img"
done
awk '
    { least[NR] = $4; most[NR] = $5; states += $7; if ($1 == "found") ++found }
    function sorted(values, n,    i, j, x) {
        for (i = 2; i <= n; ++i)
            for (j = i; j > 1 && values[j - 1] + 0 > values[j] + 0; --j) {
                x = values[j]; values[j] = values[j - 1]; values[j - 1] = x
            }
    }
    END {
        sorted(least, NR); sorted(most, NR)
        printf "%d cuts, %d attempts found, %d states compared; lost between: half %.1f and %.1f ms, most %.1f and %.1f ms\n",
            NR, found, states, least[int((NR + 1) / 2)], most[int((NR + 1) / 2)], least[NR], most[NR]
    }' "$place/results"
