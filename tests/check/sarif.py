# SPDX-License-Identifier: Apache-2.0
# sarif.py SCHEMA DOCUMENT…   Holds SARIF documents against the schema, and rules and fingerprints against their results.
import json
import sys

import jsonschema


def wrong(document, validator):
    found = [e.message for e in validator.iter_errors(document)]
    for run in document["runs"]:
        rules = run["tool"]["driver"]["rules"]
        prints = set()
        for result in run["results"]:
            if rules[result["ruleIndex"]]["id"] != result["ruleId"]:
                found.append("ruleIndex of another rule")
            prints.add(result["ruleId"] + result["partialFingerprints"]["primaryLocationLineHash"])
        if len(prints) != len(run["results"]):
            found.append("two results have one fingerprint")
        if {rule["id"] for rule in rules} != {result["ruleId"] for result in run["results"]}:
            found.append("rules that are not those of the results")
    return found


schema = json.load(open(sys.argv[1]))
validator = jsonschema.validators.validator_for(schema)(schema)
passed = failed = results = 0
for name in sys.argv[2:]:
    document = json.load(open(name))
    results += sum(len(run["results"]) for run in document["runs"])
    complaints = wrong(document, validator)
    passed += not complaints
    failed += bool(complaints)
    for complaint in complaints:
        print(name + ": " + complaint[:300])
if results < passed:
    print("%d documents have only %d results" % (passed, results))
    failed += 1
print("%d passed, %d failed" % (passed, failed))
sys.exit(failed > 0)
