#!/usr/bin/env python3
"""Makes each call of limber fail in turn, and checks how limber ends.

    faults.py LIBRARY LIMBER [--most N] [--jobs N] [--case NAME] [--table FILE]

Every case is a command line. Without a fault it writes its reference: what it
prints and its files. Then call 1 of a kind fails, then call 2, and so on, then
all calls from one on; cases.py says which commands, README.md which kinds.
--most N tries N faults of each kind of a case, evenly spread. A run is right if

- it ends by itself, within a minute, and the sanitizers report nothing;
- its exit status is 0 and everything it wrote equals the reference, or its
  exit status is 1 and it says why;
- each of its files holds what it held before, or the reference, and there are
  no others.

Prints TAP, one test a case and kind. --table FILE gets the number of faults.
"""

import argparse
import concurrent.futures
import os
import shutil
import signal
import subprocess
import sys
import tempfile

from cases import CASES, INPUTS, TREE

EARLIER = b'what was there before\n'
SHORT = ('read-short', 'write-short')
TIMEOUT_S = 60


class Run:
    """One run of a case in a folder of its own."""

    def __init__(self, options, case, fault):
        self.folder = tempfile.mkdtemp(prefix='run-', dir=options.scratch)
        for name in case.files:
            path = os.path.join(self.folder, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, 'wb') as file:
                file.write(EARLIER)
        self.report = self.folder + '.report'
        environment = dict(
            os.environ, LIMBER_CONFIG='none', LC_ALL='C.UTF-8',
            LD_PRELOAD=options.library, FAULT_REPORT=self.report,
            ASAN_OPTIONS='verify_asan_link_order=0:detect_leaks=1:'
            'allocator_may_return_null=1',
            UBSAN_OPTIONS='print_stacktrace=1',
            LSAN_OPTIONS='print_suppressions=0:suppressions=' +
            os.path.join(TREE, 'tests', 'support', 'lsan.supp'))
        environment.pop('DISPLAY', None)
        environment.pop('WAYLAND_DISPLAY', None)
        if case.own_memory:
            environment['FAULT_CALLER'] = 'program'
        if fault:
            environment['FAULT'] = fault
        try:
            ended = subprocess.run(
                [options.limber] + case.arguments, cwd=self.folder,
                env=environment, stdin=subprocess.DEVNULL,
                capture_output=True, timeout=TIMEOUT_S, check=False)
            self.status, self.out, self.err = (
                ended.returncode, ended.stdout, ended.stderr)
        except subprocess.TimeoutExpired:
            self.status, self.out, self.err = 'no end', b'', b''
        self.files = self._read_files()
        shutil.rmtree(self.folder)

    def _read_files(self):
        files = {}
        for folder, _, names in os.walk(self.folder):
            for name in names:
                path = os.path.join(folder, name)
                with open(path, 'rb') as file:
                    files[os.path.relpath(path, self.folder)] = file.read()
        return files

    def counts(self):
        """The number of calls of each kind."""
        with open(self.report, encoding='ascii') as file:
            lines = [line.split() for line in file]
        os.remove(self.report)
        return {kind: int(count) for kind, count in lines}


def files_problem(case, run, reference):
    """What is wrong with the files, or None."""
    for name, content in run.files.items():
        if name not in reference.files:
            return f'leaves {name} behind'
        if content == reference.files[name] or name in case.varying:
            continue
        if name in case.growing and reference.files[name].startswith(content):
            continue
        if content != EARLIER:
            return f'damages {name}'
    for name in reference.files:
        if name not in run.files and name in case.files:
            return f'removes {name}'
    return None


def problem(case, run, reference):
    """What is wrong with a run, or None."""
    said = run.err.decode(errors='replace')
    if b'Sanitizer' in run.err or b'runtime error' in run.err:
        return 'is reported by a sanitizer'
    if run.status == 'no end':
        return 'does not end'
    if run.status not in (0, 1):
        name = signal.Signals(-run.status).name if run.status < 0 else run.status
        return f'ends with {name}'
    wrong = files_problem(case, run, reference)
    if wrong and not (run.status == 0 and wrong.startswith('damages')):
        return wrong
    if run.status == 1 and reference.status == 0:
        if not said.startswith('limber: '):
            return 'fails without a sentence'
        return None
    if run.status != reference.status:
        return f'ends with {run.status} instead of {reference.status}'
    if case.prints_the_same and run.out != reference.out:
        return 'succeeds and prints something else'
    for name, content in reference.files.items():
        if name in case.varying:
            continue
        if run.files.get(name) != content:
            return f'succeeds without having written {name}'
    return None


def accepted(case, run, wrong):
    """Whether a case may do without what failed, as it says in a sentence."""
    said = run.err.decode(errors='replace')
    return (wrong and wrong.startswith('succeeds') and
            any(sentence in said for sentence in case.may_do_without))


def numbers(count, most):
    """Which of count calls shall fail."""
    if most <= 0 or count <= most:
        return list(range(1, count + 1))
    return sorted({1 + i * (count - 1) // max(most - 1, 1)
                   for i in range(most)})


def faults_of(kind, count, most):
    """The values of FAULT for one kind."""
    single = [f'{kind}:{n}' for n in numbers(count, most)]
    if kind in SHORT:
        return single + ([f'{kind}:1+'] if count else [])
    return single + [f'{kind}:{n}+' for n in numbers(count, max(most // 4, 4))]


def disk_faults(reference, most):
    """Disks that are too small for all of the output."""
    total = sum(len(content) for content in reference.files.values())
    sizes = {total * i // 8 for i in range(8)} | {total - 1}
    sizes |= {200 * 1024} if total > 200 * 1024 else set()
    sizes = [size for size in sizes if 0 <= size < total]
    return [f'disk:{size}' for size in sorted(sizes)[:max(most, 2)]]


class Suite:
    """Runs the cases and prints TAP."""

    def __init__(self, options):
        self.options = options
        self.tests = 0
        self.failed = 0
        self.faults = 0
        self.pool = concurrent.futures.ThreadPoolExecutor(options.jobs)

    def test(self, name, problems):
        """Prints one test; problems are sentences."""
        self.tests += 1
        self.failed += bool(problems)
        print(f'{"not ok" if problems else "ok"} {self.tests} - {name}')
        for sentence in problems[:12]:
            print(f'# {sentence}')
        if len(problems) > 12:
            print(f'# and {len(problems) - 12} more')
        sys.stdout.flush()

    def try_fault(self, case, reference, fault):
        """Returns a sentence about what was wrong, or None."""
        run = Run(self.options, case, fault)
        if os.path.exists(run.report):
            os.remove(run.report)
        wrong = problem(case, run, reference)
        if not wrong or accepted(case, run, wrong):
            return None
        said = run.err.decode(errors='replace').strip()
        if self.options.verbose:
            return f'FAULT={fault} {wrong}: {said}'.replace('\n', '\n#   ')
        return f'FAULT={fault} {wrong}: {said.splitlines()[:1]}'

    def run_case(self, case):
        """Tries all faults of a case."""
        reference = Run(self.options, case, None)
        counts = reference.counts()
        # A run that is not the same twice has no reference.
        again = Run(self.options, case, None)
        again.counts()
        wrong = problem(case, again, reference)
        if reference.status not in case.statuses or wrong:
            self.test(f'{case.name}: runs without a fault',
                      [f'status {reference.status}: {wrong}: '
                       f'{reference.err.decode(errors="replace")}'])
            return
        plans = {kind: faults_of(kind, count, self.options.most)
                 for kind, count in counts.items()}
        plans['disk'] = disk_faults(reference, self.options.most)
        for kind, faults in plans.items():
            if not faults:
                continue
            said = self.pool.map(
                lambda fault: self.try_fault(case, reference, fault), faults)
            self.faults += len(faults)
            self.test(f'{case.name}: {kind} fails {len(faults)} times',
                      [sentence for sentence in said if sentence])


def main():
    """Runs the cases that the command line names."""
    parser = argparse.ArgumentParser()
    parser.add_argument('library')
    parser.add_argument('limber')
    parser.add_argument('--most', type=int, default=0)
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    parser.add_argument('--case', action='append')
    parser.add_argument('--table')
    parser.add_argument('--verbose', action='store_true')
    options = parser.parse_args()
    options.library = os.path.abspath(options.library)
    options.limber = os.path.abspath(options.limber)
    with tempfile.TemporaryDirectory(prefix='limber-faults-') as scratch:
        options.scratch = scratch
        for name, content in INPUTS.items():
            with open(os.path.join(scratch, name), 'w',
                      encoding='ascii') as file:
                file.write(content)
        suite = Suite(options)
        for case in CASES:
            if not options.case or case.name in options.case:
                suite.run_case(case)
        print(f'# {suite.faults} faults in {suite.tests} tests')
        print(f'1..{suite.tests}')
    if options.table:
        with open(options.table, 'w', encoding='ascii') as file:
            file.write(f'{suite.faults} {suite.failed}\n')
    return 1 if suite.failed or not suite.tests else 0


if __name__ == '__main__':
    sys.exit(main())
