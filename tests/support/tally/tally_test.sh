#!/bin/sh
# Tests the tally with suites that pass, fail, skip, crash, hang or print
# nothing.
. "$(dirname "$0")/../tap.sh"
folder=$(dirname "$0")

# tally LINE...: runs a list of suites.
tally() {
    printf '%s\n' "$@" >"$scratch/list"
    run "$folder/tally.sh" "$scratch/list" "$scratch/logs"
}

# suite NAME TEXT [STATUS]: a line of a list; the suite prints TEXT.
suite() {
    printf '%b' "$2" >"$scratch/$1.tap"
    echo "$1 cat $scratch/$1.tap; exit ${3:-0}"
}

last_line() {
    tail -n 1 "$out_file"
}

# expect_total PASSED FAILED
expect_total() {
    if [ "$(last_line)" = "$1 passed, $2 failed" ]; then
        pass "$tap_about: ends with $1 passed, $2 failed"
    else
        fail "$tap_about: ends with $1 passed, $2 failed" "$(tap_show)"
    fi
}

good=$(suite good '1..2\nok 1 - one\nok 2 - two\n')

tally "$good"
about 'a suite that passes'
expect_status 0
expect_total 2 0
expect_out '^  good +2 passed +[0-9.]+ s$'

tally "$(suite late 'ok 1 - one\n1..1\n')"
about 'a plan at the end'
expect_status 0
expect_total 1 0

tally "$(suite bad '1..2\nok 1 - one\nnot ok 2 - two\n# found-by-eye\n' 1)" "$good"
about 'a suite that fails'
expect_status 1
expect_total 3 1
expect_out '# found-by-eye'
expect_out '^  good +2 passed'

tally "$(suite aim '1..2\nok 1 - one\nnot ok 2 - in 100 ms # TODO 124 ms so far\n')"
about 'an aim that is not reached'
expect_status 0
expect_total 1 0
expect_out 'not reached: aim: in 100 ms: 124 ms so far'

tally "$(suite lying '1..1\nnot ok 1 - one\n')"
about 'a failing test, exit status 0'
expect_status 1
expect_total 0 1

tally "$(suite crash '1..3\nok 1 - one\n' 139)" "$good"
about 'a suite that dies'
expect_status 1
expect_total 3 2
expect_out '1 of 3 tests ran'
expect_out 'exit status 139'

tally "$(suite early '1..3\nok 1 - one\n')"
about 'a suite that leaves early with exit status 0'
expect_status 1
expect_total 1 1

tally "$(suite many '1..1\nok 1 - one\nok 2 - two\n')"
about 'more tests than planned'
expect_status 1
expect_total 2 1

tally "$(suite leaks '1..1\nok 1 - one\n' 23)"
about 'all tests pass and the exit status does not'
expect_status 1
expect_total 1 1
expect_out 'exit status 23'

tally "$(suite planless 'ok 1 - one\n')"
about 'no plan'
expect_status 1
expect_total 1 1
expect_out 'no plan'

tally "$(suite silent '')"
about 'no output'
expect_status 1
expect_total 0 1

tally "$(suite hollow '1..0\n')"
about 'a plan of nothing'
expect_status 1
expect_total 0 1

tally "$(suite bails '1..2\nok 1 - one\nBail out! no more\n')"
about 'a suite that gives up'
expect_status 1
expect_total 1 1

tally 'missing build/no/such/program'
about 'a program that is not there'
expect_status 1
expect_total 0 2

SUITE_SECONDS=1
export SUITE_SECONDS
tally 'hang echo 1..1; sleep 30; echo ok 1'
unset SUITE_SECONDS
about 'a suite that hangs'
expect_status 1
expect_total 0 2

tally "$(suite away '1..0 # SKIP no such folder\n')" "$good"
about 'a suite that skips itself'
expect_status 0
expect_total 2 0
expect_out '^  skipped: away: no such folder$'
expect_out '^  away +0 passed, 1 skipped'

tally "$(suite away '1..0 # SKIP no such folder\n')"
about 'nothing but skipped suites'
expect_status 1
expect_total 0 0

tally "$(suite some '1..2\nok 1 - one\nok 2 - two # SKIP rain\n')"
about 'a skipped test'
expect_status 0
expect_total 1 0
expect_out '^  skipped: some: two: rain$'

tally "$(suite cm '1..2\nok 1 - one\n# skipped: rain\nnot ok 2 # SKIP two\n')"
about "cmocka 1.1.5's skipped test"
expect_status 0
expect_total 1 0
expect_out '^  skipped: cm: two: rain$'

tally "$(suite many '1..4\nok 1 - a\nok 2 - b # SKIP rain\nok 3 - c # SKIP snow\nok 4 - d # SKIP rain\n')"
about 'tests skipped for the same reason'
expect_status 0
expect_total 1 0
expect_out '^  many +1 passed, 3 skipped'
expect_out '^  skipped: many: 2 tests: rain$'
expect_out '^  skipped: many: c: snow$'

tally "$(suite cm 'TAP version 13\n1..2\nok 1 - a\nok 2 # SKIP b\n# ok - x\n')"
about "a later cmocka's skipped test"
expect_status 0
expect_total 1 0
expect_out '^  skipped: cm: b: no reason given$'

tally "$(suite setup '1..2\nnot ok 0 - x [  FAILED  ] GROUP SETUP\n# ok - x\n' 1)"
about "cmocka's group setup fails"
expect_status 1
expect_total 0 2

tally "$(suite name 'ok 1 - # SKIPPING stones is tested\n1..1\n')"
about 'a name that only looks like a skip'
expect_status 0
expect_total 1 0

tally "$(suite name 'not ok 1 - one # SKIP rain\n1..1\n' 1)"
about 'a failing test is not skipped by its name'
expect_status 1
expect_total 0 1

tally "$(suite name 'ok 1 - says \\\\# SKIP\n1..1\n')"
about 'an escaped number sign'
expect_status 0
expect_total 1 0

: >"$scratch/list"
run "$folder/tally.sh" "$scratch/list" "$scratch/logs"
about 'an empty list'
expect_status 1
expect_total 0 0

# What make test does: a suite that passed waits for a change.
echo 'echo 1..1; echo "$1 1 - one"' >"$scratch/program"
echo "kept sh $scratch/program ok" >"$scratch/list"
export REMEMBER=one
run "$folder/tally.sh" "$scratch/list" "$scratch/kept"
about 'a suite that is run for the first time'
expect_total 1 0
expect_out '^  kept +1 passed +[0-9.]+ s$'
run "$folder/tally.sh" "$scratch/list" "$scratch/kept"
about 'a suite that passed before'
expect_status 0
expect_total 1 0
expect_out '^  kept +1 passed +before$'
REMEMBER=two run "$folder/tally.sh" "$scratch/list" "$scratch/kept"
about 'a suite that passed before the shared files changed'
expect_out '^  kept +1 passed +[0-9.]+ s$'
echo 'echo 1..2; echo "$1 1 - one"; echo "ok 2 - two"' >"$scratch/program"
run "$folder/tally.sh" "$scratch/list" "$scratch/kept"
about 'a suite whose program has changed'
expect_total 2 0
echo "kept sh $scratch/program 'not ok'" >"$scratch/list"
for turn in first second; do
    run "$folder/tally.sh" "$scratch/list" "$scratch/kept"
    about "a suite that fails, for the $turn time"
    expect_status 1
    expect_total 1 1
    expect_out '^  kept +1 passed, 1 FAILED +[0-9.]+ s$'
done
unset REMEMBER

# close NAME: what make test T=NAME says when no test has the name.
close() {
    run "$folder/close_names.sh" "$1" test_clip test_clip_fit test_hud cli/pose
    about "a test called $1"
}
close clap
expect_status 2
expect_no_out
expect_err '^limber: no test is called "clap"; did you mean clip[?]$'
close test_clip_
expect_err '"clip_"; did you mean clip_fit or clip[?]$'
close xyzzyxyzzy
expect_err '"xyzzyxyzzy"; the tests are tests/unit/'
close 'pos hut'
expect_err '"pos"; did you mean pose[?]$'
expect_err '"hut"; did you mean hud[?]$'
close CLIP
expect_err '"CLIP"; did you mean clip or clip_fit[?]$'

for n in 1 2 3 4 5 6 7 8; do suite "s$n" '1..1\nok 1 - one\n'; done \
    >"$scratch/list"
run "$folder/tally.sh" "$scratch/list" "$scratch/logs" 4
about 'eight suites, four at a time'
expect_status 0
expect_total 8 0

tap_done
