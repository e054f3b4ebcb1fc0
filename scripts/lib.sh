# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# What the scripts share; sourced by them, after which the working directory is the root of the tree.

set -euo pipefail
export LC_ALL=C.UTF-8
script=$(realpath "$0")
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# A compiler cache, where there is one, serves clones in other folders too.
export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1

say() { printf '[%3d:%02d] %s\n' $((SECONDS / 60)) $((SECONDS % 60)) "$*"; }

die() {
    printf '%s: %s\n' "${script##*/}" "$*" >&2
    exit 1
}

# Prints the opening comment of the calling script, which is its help.
printHelp() { sed -n '3,/^[^#]/{/^#/!q;s/^# \{0,1\}//p}' "$script"; }

# Our own files as git sees them, new ones included, whose names match any of the patterns given.
ourFiles() {
    local file
    git ls-files --cached --others --exclude-standard -- "$@" | while read -r file; do
        if [[ -f $file ]]; then echo "$file"; fi
    done
}

# configureAndBuild PRESET TARGET [-Dname=value ...]
configureAndBuild() {
    local preset=$1 target=$2
    shift 2
    local launcher=
    if command -v ccache >/dev/null; then launcher=ccache; fi
    mkdir -p "build/$preset"
    say "configuring: preset $preset"
    if ! cmake --preset "$preset" -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" "$@" >"build/$preset/configure.log" 2>&1; then
        cat "build/$preset/configure.log" >&2
        die "configuring failed"
    fi
    say "building: $target"
    cmake --build "build/$preset" --target "$target" --parallel "$(nproc)"
}

# The ten slowest tests of the last run in a build folder, why tests were skipped, and the closing lines of ctest without its
# list of those skipped. Nothing where there was no run.
testSummary() {
    [[ -f $1/tests.xml ]] || return 0
    echo "The ten slowest tests, in seconds:"
    sed -nE 's/.*<testcase name="([^"]*)".* time="([0-9.]+)".*/\2 \1/p' "$1/tests.xml" | sort -rn | awk 'NR <= 10' |
        sed -E 's/^([0-9]+\.[0-9]{0,2})[0-9]* /\1  /; s/&quot;/"/g; s/&apos;/'"'"'/g; s/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g; s/^/    /'
    if grep -q ': Skipped$' "$1/Testing/Temporary/LastTest.log"; then
        echo "Skipped, how many and why:"
        awk '/: Skipped$/ { getline; print }' "$1/Testing/Temporary/LastTest.log" | sort | uniq -c
    fi
    echo
    awk '/tests passed,/ { on = 1 } /^The following tests did not run/ { skips = 1 } /^The following tests FAILED/ { skips = 0 }
        on && !skips' "$1/tests.log"
}
