# What XML cannot hold is escaped, what no text can hold is replaced.
args test --junit=r.xml "a&b<'>.smt"; cat r.xml

-- a&b<'>.smt --
on "quotes" & <tags>
expect ]]>
-- stdout --
0 passed, 1 failed
<?xml version="1.0" encoding="UTF-8"?>
<testsuite name="smc test" tests="1" failures="1" errors="0" skipped="0">
  <testcase name="a&#38;b&#60;'&#62;.smt" classname="smc">
    <failure message="line 2: expect takes pass, fail or error">line 2: expect takes pass, fail or error</failure>
  </testcase>
</testsuite>
-- stderr --
a&b<'>.smt: failed
    line 2: expect takes pass, fail or error
