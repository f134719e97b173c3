#!/bin/sh
# The workflow files of GitHub and GitLab run the same script in the same plain
# container. Whether the services accept them can only be seen there. FILES are
# the workflow files to look at.
. "$(dirname "$0")/../support/tap.sh"
cd "$(dirname "$0")/../.." || exit 1

# lacks FILE: what a workflow file lacks or has too much of, a line each.
lacks() {
    grep -Eq '^ *(container|image): debian:12$' "$1" ||
        echo 'it does not run in debian:12'
    grep -Eq '^ *(- |run: |- run: )\.ci/run$' "$1" ||
        echo 'it does not run .ci/run'
    grep -Eq 'apt-get install -y --no-install-recommends git make ca-certificates$' \
        "$1" || echo 'it does not install git, make and certificates alone'
    grep -Eq '^ *(timeout-minutes: 180|timeout: 3 hours)$' "$1" ||
        echo 'it does not allow three hours'
    ! grep -Eq '^ *(- )?(cache|uses: actions/cache.*|DOCKER_HOST|privileged):?' "$1" ||
        echo 'it relies on a cache or on a machine of its own'
}

for file in ${FILES:-.github/workflows/check.yml .gitlab-ci.yml}; do
    check "$file runs .ci/run in a plain Debian 12" \
        test -z "$(lacks "$file" | tee "$scratch/lacks")"
    sed 's/^/# /' "$scratch/lacks"
done
check '.ci/run can be executed' test -x .ci/run
check '.ci/run runs make check' grep -qx 'exec make check' .ci/run
tap_done
