#!/bin/sh
# SPDX-License-Identifier: MIT
# The life of the service's package, inside the root that clean_root.sh makes.
set -eu
cd /root/packages
export DEBIAN_FRONTEND=noninteractive
say() { echo "life: $*" >&2; }
fail() { say "FAILED: $*"; exit 1; }
wants=/etc/systemd/system/multi-user.target.wants/raymarchd.service

apt-get install -q -y ./raymarchd_*.deb >&2
{ raymarchd --version >&2 && raymarchd --check-config >&2; } || fail "the service does not run"
raymarchctl encode 'FX=0,FY=0,FZ=1,RX=1,RY=0,RZ=0,UX=0,UY=1,UZ=0,ZM=3,LX=3,LY=2,LZ=5,R=1,G=1,B=1,OBJ=sphere' >&2 ||
    fail "the tool does not run"
raymarchctl render --size 16x12 -o /tmp/a.ppm >&2 || fail "the tool does not draw"
raymarchctl render --size 16x12 -o /tmp/a.png >&2 || fail "no PNG without the pictures' package"
! raymarchctl render --size 16x12 -o /tmp/a.jpg >&2 || fail "a JPEG without the pictures' package"
[ -e /lib/firmware/raymarch.dtbo ] || fail "the overlay is not where the tool looks for it"
[ -L "$wants" ] || fail "it is not enabled"
{ getent passwd raymarchd >&2 && getent group uio gpio >&2; } || fail "no user, or no groups"
! dpkg -l | grep -q libopencv || fail "OpenCV came along"
say "installed, without OpenCV; it writes PNG"

apt-get install -q -y -s ./raymarchd-pictures_*.deb >/tmp/plan
grep -q '^Inst libopencv-imgcodecs' /tmp/plan || fail "the pictures' package does without OpenCV"
say "the pictures' package can be installed, with OpenCV"

apt-get install -q -y ./next1.deb >&2
grep -q '^# as of next1$' /etc/raymarchd.toml || fail "the upgrade left an unchanged configuration as it was"
echo 'log_level = "info"' >>/etc/raymarchd.toml
mkdir -p /var/lib/raymarchd && echo kept >/var/lib/raymarchd/state
touch /lib/firmware/raymarch.bit /lib/firmware/raymarch.bin # the user's, and what is made of it
# Both have changed now: dpkg would ask, and is told what it proposes.
apt-get install -q -y -o Dpkg::Options::=--force-confdef -o Dpkg::Options::=--force-confold ./next2.deb >&2
dpkg-query -W -f '${Version}' raymarchd | grep -q 'next2$' || fail "not upgraded"
grep -q '^log_level = "info"$' /etc/raymarchd.toml || fail "the upgrade took the configuration away"
grep -q '^# as of next2$' /etc/raymarchd.toml.dpkg-dist || fail "the new configuration is not beside it"
[ -e /var/lib/raymarchd/state ] || fail "the upgrade took the state away"
[ -L "$wants" ] || fail "the upgrade disabled it"
say "upgraded, changed configuration and state kept"

apt-get remove -q -y raymarchd >&2
[ ! -e /usr/sbin/raymarchd ] || fail "the service is still there"
{ [ -e /etc/raymarchd.toml ] && [ -e /var/lib/raymarchd/state ]; } || fail "remove is not purge"
say "removed, configuration and state kept"

apt-get purge -q -y raymarchd >&2
[ -e /lib/firmware/raymarch.bit ] || fail "purge took the user's bitstream"
rm /lib/firmware/raymarch.bit
left=$(find /etc /usr /var /run -xdev -iname '*raymarch*' -not -path '/var/log/*' -not -path '/var/cache/*')
[ -z "$left" ] || fail "purge left: $left"
say "purged, nothing left"
