#!/usr/bin/env python3
"""Makes each call of limber fail in turn, and checks how limber ends.

    faults.py LIBRARY LIMBER [--every | --once] [--frames N] [--most N]
              [--later N] [--jobs N] [--own | --case NAME] [--table FILE]

Every case is a command line. Without a fault it writes its reference: what it
prints and its files, and the sites of its calls: the chains of functions that
lead to them. Then the first call of one site fails after the other, and then all
calls from one on; cases.py says which commands, README.md which kinds.

--every     lets every call fail, not only the first of each site
--once      lets a site fail only in the first case that reaches it
--frames N  tells sites apart by the N nearest frames of limber alone
--own       leaves out the command lines of tests/golden
--most N    tries N faults of each kind of a case, evenly spread
--later N   tries N faults after which all calls fail, and N sizes of a disk

A run is right if

- it ends by itself, within a minute, and the sanitizers report nothing;
- its exit status is 0 and everything it wrote equals the reference, or its
  exit status is 1 and it says why;
- each of its files holds what it held before, or the reference, and there are
  no others.

Prints TAP, one test a case and kind. --table FILE gets the number of faults.
"""

import argparse
import concurrent.futures
import dataclasses
import functools
import os
import shutil
import signal
import subprocess
import sys
import tempfile

from cases import CASES, INPUTS, TREE

EARLIER = b'what was there before\n'
SHORT = ('read-short', 'write-short')
LATER = 8    # faults of a kind and case after which all calls fail, and disks
FRAMES = 10  # of a site: longer chains tell 2% more sites apart
TIMEOUT_S = 60


@functools.lru_cache(None)
def content_of(path):
    """What a file of the tree holds."""
    with open(path, 'rb') as file:
        return file.read()


def earlier(case, name):
    """What a file of a case holds before its run."""
    return content_of(case.given[name]) if name in case.given else EARLIER


class Run:
    """One run of a case in a folder of its own."""

    def __init__(self, options, case, fault):
        self.folder = tempfile.mkdtemp(prefix='run-', dir=options.scratch)
        for name in {*case.files, *case.given}:
            path = os.path.join(self.folder, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, 'wb') as file:
                file.write(earlier(case, name))
        self.report = self.folder + '.report'
        environment = dict(
            os.environ, LIMBER_CONFIG='none', LC_ALL='C.UTF-8',
            LD_PRELOAD=options.library, FAULT_REPORT=self.report,
            ASAN_OPTIONS='verify_asan_link_order=0:detect_leaks=1:'
            'allocator_may_return_null=1',
            UBSAN_OPTIONS='print_stacktrace=1',
            LSAN_OPTIONS='print_suppressions=0:suppressions=' +
            os.path.join(TREE, 'tests', 'support', 'lsan.supp'))
        if case.given:
            environment['LIMBER_ASSETS'] = self.folder
        environment.pop('DISPLAY', None)
        environment.pop('WAYLAND_DISPLAY', None)
        if not fault and not options.every:
            environment['FAULT_SITES'] = str(options.frames)
        environment.update(case.variables)
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
        """For each kind the number of calls, and (first call, site) of each site."""
        with open(self.report, encoding='ascii') as file:
            lines = [line.split() for line in file]
        os.remove(self.report)
        counts = {}
        for kind, count, *sites in lines:
            pairs = [site.split(':') for site in sites]
            counts[kind] = (int(count), sorted(
                (int(number), site) for number, site in pairs))
        return counts


def files_problem(case, run, reference):
    """What is wrong with the files, or None."""
    for name, content in run.files.items():
        if name in case.leaves and run.status != 0:
            continue
        if name not in reference.files:
            return f'leaves {name} behind'
        if content == reference.files[name] or name in case.varying:
            continue
        if name in case.growing and reference.files[name].startswith(content):
            continue
        if content != earlier(case, name):
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
    if b'image is broken' in run.err and b'image is broken' not in reference.err:
        return 'blames an image'
    if run.status == 'no end':
        return 'does not end'
    if run.status not in (0, 1, reference.status):
        name = signal.Signals(-run.status).name if run.status < 0 else run.status
        return f'ends with {name}'
    wrong = files_problem(case, run, reference)
    if wrong and not (run.status == 0 and wrong.startswith('damages')):
        return wrong
    if run.status == 1 and reference.status != 1:
        if not case.finds and not said.startswith('limber: '):
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


def spread(numbers, most):
    """At most so many of the numbers, evenly spread; 0: all."""
    count = len(numbers)
    if most <= 0 or count <= most:
        return numbers
    return [numbers[i * (count - 1) // max(most - 1, 1)] for i in range(most)]


def faults_of(kind, numbers, most, later):
    """The values of FAULT that let these calls of a kind fail."""
    single = [f'{kind}:{n}' for n in spread(numbers, most)]
    if kind in SHORT:
        return single + ([f'{kind}:1+'] if numbers else [])
    last = spread(numbers, min(most, later) if most else later)
    return single + [f'{kind}:{n}+' for n in last]


def disk_faults(reference, most):
    """Disks that are too small for all of the output: at most so many, from an
    empty one to one that lacks a byte."""
    total = sum(len(content) for content in reference.files.values())
    sizes = {total * i // 8 for i in range(8)} | {total - 1}
    sizes |= {200 * 1024} if total > 200 * 1024 else set()
    sizes = sorted(size for size in sizes if 0 <= size < total)
    return [f'disk:{size}' for size in spread(sizes, most)]


class Suite:
    """Runs the cases and prints TAP."""

    def __init__(self, options):
        self.options = options
        self.tests = 0
        self.failed = 0
        self.faults = 0
        self.seen = set()
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

    def calls(self, case, count, sites):
        """The numbers of the calls of a kind and case that shall fail."""
        if self.options.every:
            return list(range(1, count + 1))
        if self.options.once or case.reference:
            sites = [site for site in sites if site[1] not in self.seen]
        self.seen.update(site for _, site in sites)
        return [number for number, _ in sites]

    def run_case(self, case):
        """Tries all faults of a case."""
        reference = Run(self.options, case, None)
        plans = {kind: faults_of(kind, self.calls(case, *calls),
                                 self.options.most, self.options.later)
                 for kind, calls in reference.counts().items()}
        # A run that is not the same twice has no reference; one is enough to see
        # that the sanitizers report nothing.
        again = reference
        if not case.reference or any(plans.values()):
            again = Run(self.options, case, None)
            again.counts()
        if case.reference:
            case = dataclasses.replace(
                case, files=tuple(reference.files),
                prints_the_same=(case.prints_the_same and
                                 again.out == reference.out), varying=tuple(
                    name for name, content in reference.files.items()
                    if again.files.get(name) != content))
        wrong = problem(case, again, reference)
        if reference.status not in case.statuses or wrong:
            self.test(f'{case.name}: runs without a fault',
                      [f'status {reference.status}: {wrong}: '
                       f'{reference.err.decode(errors="replace")}'])
            return
        if not case.reference:
            plans['disk'] = disk_faults(reference, self.options.later)
        if case.kinds:
            plans = {kind: plans[kind] for kind in case.kinds}
        for kind, faults in plans.items():
            if not faults:
                continue
            said = self.pool.map(
                lambda fault: self.try_fault(case, reference, fault), faults)
            self.faults += len(faults)
            self.test(f'{case.name}: {kind} fails {len(faults)} times',
                      [sentence for sentence in said if sentence])


def write_inputs(options):
    """Writes the files beside the folders of the cases."""
    for name, content in INPUTS.items():
        with open(os.path.join(options.scratch, name), 'w',
                  encoding='ascii') as file:
            file.write(content)
    subprocess.run([options.limber, 'levels', 'known.gltf', '-o', 'known.levels'],
                   cwd=options.scratch, check=True)


def main():
    """Runs the cases that the command line names."""
    parser = argparse.ArgumentParser()
    parser.add_argument('library')
    parser.add_argument('limber')
    parser.add_argument('--most', type=int, default=0)
    parser.add_argument('--later', type=int, default=LATER)
    parser.add_argument('--every', action='store_true')
    parser.add_argument('--once', action='store_true')
    parser.add_argument('--frames', type=int, default=FRAMES)
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    parser.add_argument('--case', action='append')
    parser.add_argument('--own', action='store_true')
    parser.add_argument('--table')
    parser.add_argument('--verbose', action='store_true')
    options = parser.parse_args()
    options.library = os.path.abspath(options.library)
    options.limber = os.path.abspath(options.limber)
    with tempfile.TemporaryDirectory(prefix='limber-faults-') as scratch:
        options.scratch = scratch
        write_inputs(options)
        suite = Suite(options)
        for case in CASES:
            if options.case and case.name not in options.case:
                continue
            if not (options.own and case.reference):
                suite.run_case(case)
        print(f'# {suite.faults} faults in {suite.tests} tests')
        print(f'1..{suite.tests}')
    if options.table:
        with open(options.table, 'w', encoding='ascii') as file:
            file.write(f'{suite.faults} {suite.failed}\n')
    return 1 if suite.failed or not suite.tests else 0


if __name__ == '__main__':
    sys.exit(main())
