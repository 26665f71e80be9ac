#!/bin/sh
# SPDX-License-Identifier: MIT
# A hook of mmdebstrap: settles the virtual board's Debian. $1 is its tree.
#
# The console logs root in by itself: whoever has the console of this board has its memory file too.
set -eu
tree=$1
echo pynq-z1-virtual >"$tree/etc/hostname"
echo '/dev/mmcblk0 / ext4 defaults,noatime 0 1' >"$tree/etc/fstab"
# Entropy and identity that a first boot would make, slowly.
echo 00000000000000000000000000000001 >"$tree/etc/machine-id"
mkdir -p "$tree/etc/systemd/system/serial-getty@ttyPS0.service.d"
cat >"$tree/etc/systemd/system/serial-getty@ttyPS0.service.d/login.conf" <<'UNIT'
[Service]
ExecStart=
ExecStart=-/sbin/agetty --autologin root --noclear --keep-baud 115200 %I dumb
UNIT
# There is no network to wait for, no clock to be set from it, and this kernel has no modules: every
# program that is not run at the boot is time, as all of them are emulated.
mkdir -p "$tree/etc/systemd/journald.conf.d"
printf '[Journal]\nStorage=volatile\n' >"$tree/etc/systemd/journald.conf.d/board.conf"
for unit in systemd-networkd-wait-online.service systemd-timesyncd.service systemd-resolved.service \
    apt-daily.timer apt-daily-upgrade.timer dpkg-db-backup.timer fstrim.timer e2scrub_all.timer \
    e2scrub_reap.service getty-static.service kmod-static-nodes.service systemd-update-utmp.service \
    systemd-update-utmp-runlevel.service systemd-pstore.service modprobe@configfs.service \
    modprobe@dm_mod.service modprobe@drm.service modprobe@efi_pstore.service modprobe@fuse.service \
    modprobe@loop.service; do
    ln -sf /dev/null "$tree/etc/systemd/system/$unit"
done
