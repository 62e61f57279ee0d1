#!/usr/bin/env bash
# The Debian packages in a clean root of Debian 12: they install with what they depend on,
# the program runs, reproduces its tables and judges gates, a program of one's own finds the
# libraries, and nothing stays when they are removed. Needs to be root, debootstrap, lintian
# and a network; takes half an hour.
# Usage: package_test.sh [--quick]    (--quick: one case in place of reproduce)
set -euo pipefail
clone=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
what=reproduce
[ "${1:-}" != --quick ] || what=quick
root=$(mktemp -d)
leave() {
  umount -q "$root/proc" "$root/dev" 2>/dev/null || true
  rm -rf --one-file-system "$root"
}
trap leave EXIT

bash "$clone/scripts/install_packages.sh" "$clone/scripts/packages_for_packages.txt"
bash "$clone/scripts/package.sh"
lintian --fail-on error "$clone"/build/packages/*.deb

debootstrap --variant=minbase bookworm "$root" >/dev/null
chmod 755 "$root"
cp /etc/resolv.conf "$root/etc/"
cp -r /etc/apt/apt.conf.d "$root/etc/apt/"
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
cp "$clone"/build/packages/*.deb "$root/tmp/"

inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/srv LANG=C.UTF-8 \
  DEBIAN_FRONTEND=noninteractive ${http_proxy:+http_proxy="$http_proxy"} \
  ${https_proxy:+https_proxy="$https_proxy"} bash -euo pipefail -c "$1"; }
files() { (cd "$root" && find usr etc opt var/lib -path var/lib/dpkg -prune -o \
  -path var/lib/apt -prune -o -print | grep -i springcheck || true); }

inside "apt-get update -qq && apt-get install -y -qq --no-install-recommends /tmp/springcheck_*.deb"
inside "springcheck --version && springcheck run compression --out /srv/first.h5"
inside "springcheck report /srv/first.h5 --out /srv/page && test -s /srv/page/index.html"
inside "cp -r /usr/share/doc/springcheck/examples /srv/examples && cd /srv/examples &&
  bash own_method/run.sh && bash gates/run.sh"
mkdir -p "$root/srv/pipeline/tools"
cp "$clone"/examples/gates/*.toml "$root/srv/pipeline/"
cp "$root"/tmp/springcheck_*.deb "$root/srv/pipeline/tools/springcheck.deb"
/usr/bin/python3 -c '
import sys, yaml
steps = yaml.safe_load(open(sys.argv[1]))["jobs"]["accuracy"]["steps"]
print("\n".join(step["run"] for step in steps if "run" in step))
' "$clone/examples/gates/pipeline.yml" >"$root/srv/pipeline/steps.sh"
inside "cd /srv/pipeline && bash -euo pipefail steps.sh && test -s gates.xml"
inside "python3 -c 'import springcheck_results as r; print(r.read(\"/srv/first.h5\").cases.status)'"
if [ "$what" = reproduce ]; then
  inside "springcheck reproduce --out /srv/results && test -s /srv/results/index.html"
fi

inside "apt-get install -y -qq --no-install-recommends cmake g++ make /tmp/libspringcheck-dev_*.deb"
inside "cd /srv/examples && cmake -S own_spring -B /srv/own && cmake --build /srv/own &&
  /srv/own/own_spring"

inside "apt-get purge -y -qq springcheck libspringcheck-dev"
left=$(files)
if [ -n "$left" ]; then
  printf 'expected nothing of springcheck after its removal, got\n%s\n' "$left" >&2
  exit 1
fi
