# Counts the tests in a suite's TAP. Variables: suite is the suite's name, status
# the exit status of its command.
#
# Prints one line "passed failed skipped", then a line "skip WHERE: WHY" for
# each reason to skip, a line "todo WHERE: WHAT" for each aim that is not reached
# yet ("not ok N - WHAT # TODO WHY"), and a line "fail WHY" for each fault of the
# suite as a whole: no plan, an empty plan, tests missing, a failing exit status
# that no test explains.
#
# cmocka 1.1.5 calls a skipped test "not ok N # SKIP NAME", and a failing group
# fixture "not ok 0"; a line "# skipped: WHY" before a skip is its reason.

function add_skip(name, why) {
    skipped++
    sub(/^ *-? */, "", name)
    sub(/ *$/, "", name)
    if (why == "") {
        why = "no reason given"
    }
    if (!(why in count_of)) {
        reason[++reasons] = why
        first[why] = name == "" ? "" : name ": "
    }
    count_of[why]++
}

/^1\.\.[0-9]+/ {
    plans++
    split(substr($1, 4), number, /[^0-9]/)
    planned += number[1]
    at = match(toupper($0), /# *SKIP/)
    if (at && number[1] == 0) {
        whole = 1
        why = substr($0, at + RLENGTH)
        sub(/^[^ ]* */, "", why)
        add_skip("", why)
    }
    next
}

/^# skipped: / {
    pending = substr($0, 12)
    next
}

/^Bail out!/ {
    bailed = 1
    next
}

# An aim that is not reached yet is reported and does not count as a failure.
/^not ok .*[^\\]# *TODO( |$)/ {
    name = $0
    sub(/^not ok *[0-9]* *-? */, "", name)
    sub(/ *# *TODO */, ": ", name)
    todo[++todos] = name
    seen++
    next
}

/^(not )?ok($| )/ {
    good = $1 == "ok"
    rest = $0
    sub(/^(not )?ok */, "", rest)
    counted = rest !~ /^0( |$)/
    sub(/^[0-9]+ */, "", rest)
    seen += counted
    # "not ok" counts as skipped only in cmocka's form, which has no name.
    at = match(toupper(rest), /(^|[^\\])# *SKIP(PED)?( |$)/)
    if (at && (good || at == 1)) {
        name = substr(rest, 1, at - 1 + (at > 1))
        why = substr(rest, at + RLENGTH)
        if (name == "") {
            # In cmocka's form, the test's name follows.
            name = why
            why = pending
        }
        add_skip(name, why == "" ? pending : why)
    } else if (good) {
        passed++
    } else {
        failed++
    }
    pending = ""
}

END {
    if (bailed) {
        wrong[++wrongs] = "it gave up"
    } else if (plans == 0) {
        wrong[++wrongs] = "no plan in its output"
    } else if (planned == 0 && !whole) {
        wrong[++wrongs] = "a plan of no tests"
    } else if (seen != planned) {
        wrong[++wrongs] = seen + 0 " of " planned " tests ran"
    }
    if (status != 0 && failed == 0) {
        wrong[++wrongs] = "exit status " status
    }
    print passed + 0, failed + wrongs, skipped + 0
    for (i = 1; i <= reasons; i++) {
        why = reason[i]
        many = count_of[why] > 1
        print "skip " suite ": " \
            (many ? count_of[why] " tests: " : first[why]) why
    }
    for (i = 1; i <= todos; i++) {
        print "todo " suite ": " todo[i]
    }
    for (i = 1; i <= wrongs; i++) {
        print "fail " suite ": " wrong[i]
    }
}
