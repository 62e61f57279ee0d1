#!/usr/bin/env bash
# Installs the Debian packages of packages.txt, and of the lists that are named, that are
# missing; asks apt only then. Usage: bash scripts/install_packages.sh [LIST.txt...]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

missing=()
while read -r package; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done < <(cat "$here/packages.txt" "$@" | grep -v '^#')
[ ${#missing[@]} -eq 0 ] && exit 0

give_up() {
  echo "These Debian packages are missing and could not be installed ($1):" >&2
  echo "    ${missing[*]}" >&2
  echo "Install them, for example with: sudo apt-get install ${missing[*]}" >&2
  exit 1
}
command -v apt-get >/dev/null || give_up "there is no apt-get"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || give_up "not root, and there is no sudo"
  as_root=(sudo)
fi

echo "Installing: ${missing[*]}" >&2
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq >&2 || give_up "apt-get update failed"
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2 ||
  give_up "apt-get install failed"
