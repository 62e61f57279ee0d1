#!/usr/bin/env bash
# Makes the pictures of README and documentation anew (docs/pictures), each by the commands
# of the tutorial's page that it ends.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash scripts/build.sh
bash scripts/install_packages.sh scripts/packages_for_tests.txt
for page in docs/tutorial/*.md; do
  /usr/bin/python3 -B tests/docs/snippets_test.py "$page" --take-pictures
done
