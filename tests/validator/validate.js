// node validate.js FILE...: prints one TAP test for each glTF file. The test
// passes when the Khronos validator finds no error; warnings are printed.
'use strict';
const fs = require('fs');
const path = require('path');
const validator = require('gltf-validator');

const ERROR = 0;
const HINT = 3;

function readBeside(file) {
    return async (uri) => new Uint8Array(await fs.promises.readFile(
        path.resolve(path.dirname(file), decodeURIComponent(uri))));
}

async function problemsOf(file) {
    try {
        const report = await validator.validateBytes(
            new Uint8Array(fs.readFileSync(file)),
            { uri: path.basename(file),
              externalResourceFunction: readBeside(file) });
        return report.issues.messages.filter((m) => m.severity < HINT);
    } catch (error) {
        return [{ severity: ERROR, code: 'UNREADABLE', pointer: '',
                  message: String(error) }];
    }
}

async function main(files) {
    let failures = 0;
    console.log(`1..${files.length}`);
    for (const [i, file] of files.entries()) {
        const problems = await problemsOf(file);
        const bad = problems.some((p) => p.severity === ERROR);
        failures += bad;
        console.log(`${bad ? 'not ok' : 'ok'} ${i + 1} - ${file}`);
        for (const p of problems.slice(0, 20)) {
            const kind = ['error', 'warning', 'information'][p.severity];
            console.log(`# ${kind}: ${p.code} ${p.pointer || ''}: ${p.message}`);
        }
    }
    process.exitCode = failures ? 1 : 0;
}

main(process.argv.slice(2));
