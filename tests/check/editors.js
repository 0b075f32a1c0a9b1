// SPDX-License-Identifier: Apache-2.0
// editors.js GRAMMAR SAMPLES: as editors.py, with the packages that VS Code reads grammars with: vscode-textmate and vscode-oniguruma.
const fs = require('fs'), textmate = require('vscode-textmate'), oniguruma = require('vscode-oniguruma');
const [grammarFile, samplesFile] = process.argv.slice(2);

async function loadGrammar() {
    await oniguruma.loadWASM(fs.readFileSync(require.resolve('vscode-oniguruma/release/onig.wasm')).buffer);
    const onigLib = Promise.resolve({
        createOnigScanner: patterns => new oniguruma.OnigScanner(patterns),
        createOnigString: text => new oniguruma.OnigString(text)});
    const read = async () => textmate.parseRawGrammar(fs.readFileSync(grammarFile, 'utf8'), grammarFile);
    return new textmate.Registry({onigLib, loadGrammar: read}).loadGrammar('source.smc');
}

// The scope of the token that contains all of the word; '-' if it has none.
function scopeOf(grammar, line, at, word) {
    const token = grammar.tokenizeLine(line, textmate.INITIAL).tokens.find(t => t.startIndex <= at && at < t.endIndex);
    return token.endIndex < at + word.length ? 'several tokens' : token.scopes.length > 1 ? token.scopes[token.scopes.length - 1] : '-';
}

loadGrammar().then(grammar => {
    let passed = 0, failed = 0;
    for (const row of fs.readFileSync(samplesFile, 'utf8').split('\n').filter(row => row && row[0] !== '#')) {
        const [file, text, word, scope] = row.split(' | ').map(cell => cell.trim());
        const line = fs.readFileSync(file, 'utf8').split('\n').find(l => l.trim().startsWith(text));
        const got = line === undefined ? 'no such line' : scopeOf(grammar, line, line.indexOf(text) + text.lastIndexOf(word), word);
        if (got === (scope === '-' ? '-' : scope + '.smc'))
            passed++;
        else {
            failed++;
            console.log(`${file}: ${text}: ${word}: expected ${scope}, got ${got}`);
        }
    }
    console.log(passed, failed);
});
