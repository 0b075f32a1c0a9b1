# SPDX-License-Identifier: Apache-2.0
# junit.py FILE.xml…: compares files of `smc test --junit` with what Jenkins accepts (its xUnit plugin checks a schema), what GitLab and the
# reporters for GitHub read, and against themselves: counts and times add up, a test is there once.
# junit.py --self-test FILE.xml: damages a good file in many ways; each must be noticed.
import re
import sys
import xml.etree.ElementTree as ET

TIME = re.compile(r'[0-9]+\.[0-9]{6}$')
COUNT = re.compile(r'[0-9]+$')
WORD = re.compile(r'(?s).+')
CODE = re.compile(r'[A-Z][0-9]{4}$')

# element: (required attributes, optional attributes, elements in it, whether it can contain text)
RESULT = ({'message': WORD}, {'type': CODE}, set(), True)
SCHEMA = {
    'testsuites': ({'name': WORD, 'tests': COUNT, 'failures': COUNT, 'errors': COUNT, 'time': TIME}, {}, {'testsuite'}, False),
    'testsuite': ({'name': WORD, 'tests': COUNT, 'failures': COUNT, 'errors': COUNT, 'skipped': COUNT, 'time': TIME}, {'file': WORD},
                  {'testcase'}, False),
    'testcase': ({'name': WORD, 'classname': WORD, 'time': TIME}, {}, {'failure', 'error', 'skipped'}, False),
    'failure': RESULT,
    'error': RESULT,
    'skipped': RESULT,
}


def check_form(e, wrong):
    if e.tag not in SCHEMA:
        wrong.append('unknown element ' + e.tag)
        return
    needed, allowed, inside, text = SCHEMA[e.tag]
    for name, form in needed.items():
        if not form.match(e.get(name, '')):
            wrong.append('%s: %s="%s"' % (e.tag, name, e.get(name)))
    for name, value in e.attrib.items():
        if name not in needed and not (name in allowed and allowed[name].match(value)):
            wrong.append('%s: attribute %s="%s"' % (e.tag, name, value))
    if not text and (e.text or '').strip():
        wrong.append('%s: text' % e.tag)
    if text and not (e.text or '').strip():
        wrong.append('%s: no text' % e.tag)
    for inner in e:
        if (inner.tail or '').strip():
            wrong.append('%s: text behind %s' % (e.tag, inner.tag))
        if inner.tag not in inside:
            wrong.append('%s in %s' % (inner.tag, e.tag))
        check_form(inner, wrong)


def check_sums(e, cases, wrong):
    of = lambda tag: sum(1 for c in cases if c.find(tag) is not None)
    found = {'tests': len(cases), 'failures': of('failure'), 'errors': of('error'), 'skipped': of('skipped')}
    for name, n in found.items():
        if name in e.attrib and e.get(name) != str(n):
            wrong.append('%s: %s="%s", but there are %d' % (e.tag, name, e.get(name), n))
    seconds = sum(float(c.get('time', 0)) for c in cases)
    if abs(seconds - float(e.get('time', -1))) > 1e-6 * (len(cases) + 1):
        wrong.append('%s: time="%s", but its cases took %f' % (e.tag, e.get('time'), seconds))


def check(text):
    wrong = []
    try:
        root = ET.fromstring(text)
    except ET.ParseError as why:
        return ['not XML: %s' % why], 0
    if root.tag != 'testsuites':
        wrong.append('the root is ' + root.tag)
    check_form(root, wrong)
    if wrong:
        return wrong, 0
    cases = list(root.iter('testcase'))
    check_sums(root, cases, wrong)
    for suite in root:
        check_sums(suite, list(suite), wrong)
    names = [(c.get('classname'), c.get('name')) for c in cases]
    for name in sorted(set(names)):
        if names.count(name) > 1:
            wrong.append('%s.%s is there %d times' % (name + (names.count(name),)))
    for c in cases:
        if len(c) > 1:
            wrong.append('%s has several results' % c.get('name'))
        for result in c:                                  # where, what and which: in the line that is shown, and in the text
            if result.get('message') not in result.text:
                wrong.append('%s: the message is not in the text' % c.get('name'))
            if result.get('type') and not re.match(r'(not announced: )?[^:]+:[0-9]+:[0-9]+: error: ', result.get('message')):
                wrong.append('%s: no file and line in "%s"' % (c.get('name'), result.get('message')))
    if len(set(s.get('name') for s in root)) != len(root):
        wrong.append('two suites have one name')
    return wrong, len(cases)


SPOILED = [
    (r'<testsuites name="smc test"', '<testsuites'), (r'tests="[0-9]+"', 'tests="999"'), (r'failures="[0-9]+"', 'failures="999"'),
    (r'errors="[0-9]+"', 'errors="999"'), (r'skipped="[0-9]+"', 'skipped="999"'), (r' skipped="[0-9]+"', ''),
    (r'time="[0-9.]+"', 'time="99.000000"'), (r'time="[0-9.]+"', 'time="soon"'), (r' classname="[^"]*"', ''), (r'<testcase name=', '<testcase line="1" name='),
    (r'type="E[0-9]+"', 'type="AssertionError"'), (r'(?s)<failure.*?</failure>', '<failure/>'), (r'(?s)<failure(.*?)</failure>', r'<error\1</error>'),
    (r'(?s)(<failure.*?</failure>)', r'\1\1'), (r'(?s)(    <testcase.*?/>\n)', r'\1\1'), (r'</testsuites>', ''), (r'&#60;', '<'),
    (r'<testsuites(.*?)>', r'<testsuites\1>text'), (r'message="[^"]*"', 'message="something"'), (r'<testsuite name', '<suite/><testsuite name'),
]


def main():
    failed = passed = 0
    if sys.argv[1] == '--self-test':
        text = open(sys.argv[2]).read()
        for pattern, by in SPOILED:
            spoiled = re.sub(pattern, by, text, count=1)
            if spoiled != text and check(spoiled)[0]:
                passed += 1
            else:
                print('not noticed: %s by %s' % (pattern, by))
                failed += 1
    for path in sys.argv[1:] if sys.argv[1] != '--self-test' else []:
        wrong, cases = check(open(path).read())
        if not wrong and cases == 0:
            wrong = ['no test case is in it']
        for line in wrong:
            print('%s: %s' % (path, line))
        passed, failed = passed + (not wrong), failed + bool(wrong)
    print('%d passed, %d failed' % (passed, failed))
    return failed != 0


sys.exit(main())
