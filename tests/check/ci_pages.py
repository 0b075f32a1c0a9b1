# SPDX-License-Identifier: Apache-2.0
# ci_pages.py FOLDER: the examples of docs/ci.md for CI servers, as tests/check/docs.sh has put them there, parsed.  FOLDER also contains ci.sh
# and the folder `results` that it has written.
import fnmatch
import os
import subprocess
import sys

import yaml

folder = sys.argv[1]
written = ['results/' + name for name in os.listdir(folder + '/results')] + ['results']
passed = failed = 0


def check(what, good):
    global passed, failed
    passed += bool(good)
    failed += not good
    if not good:
        print('ci_pages: ' + what)


def check_shell(name, text):
    check(name + ': the shell cannot parse: ' + text, subprocess.run(['sh', '-n', '-c', text], stderr=subprocess.DEVNULL).returncode == 0)
    check(name + ': runs a script that the page does not have: ' + text, all(os.path.exists(f'{folder}/{w}') for w in text.split() if w.endswith('.sh')))


def check_result(name, pattern):
    check(f'{name}: the recipe does not write {pattern}', fnmatch.filter(written, pattern))


def check_github(name):
    page = yaml.safe_load(open(f'{folder}/{name}'))
    check(name + ': no trigger', page.get('on', page.get(True)))          # YAML 1.1 reads `on` as true
    for job in page['jobs'].values():
        check(name + ': no runner', isinstance(job['runs-on'], str))
        ids = {step['id'] for step in job['steps'] if 'id' in step}
        for step in job['steps']:
            check(f'{name}: a step runs a command or uses an action: {step}', ('run' in step) != ('uses' in step))
            check(f'{name}: an action without a version: {step}', 'uses' not in step or '@v' in step['uses'])
            for part in str(step).split('steps.')[1:]:
                check(f'{name}: a step that is not there: {part}', part.split('.')[0] in ids)
            if 'run' in step:
                check_shell(name, step['run'])
            for key, value in step.get('with', {}).items():
                if key in ('sarif_file', 'path') and value.startswith('results'):
                    check_result(name, value)
        check(name + ': SARIF is not uploaded', any('upload-sarif' in step.get('uses', '') for step in job['steps']))
    check(name + ': no permission to upload SARIF', page['permissions'].get('security-events') == 'write')


def check_gitlab(name):
    page = yaml.safe_load(open(f'{folder}/{name}'))
    for job in page.values():
        for line in job['before_script'] + job['script']:
            check(f'{name}: a command is no text: {line}', isinstance(line, str))
            check_shell(name, str(line))
        check_result(name, job['artifacts']['reports']['junit'])
        for path in job['artifacts']['paths']:
            check_result(name, path)


check_github('github.yml')
check_gitlab('gitlab.yml')
print(f'{passed} passed, {failed} failed')
sys.exit(failed != 0)
