# What XML cannot hold is escaped, what no text can hold is replaced.
args test --junit=r.xml "a&b<'>.smt"; cat r.xml

-- a&b<'>.smt --
on "quotes" & <tags>
expect ]]>
-- stdout --
0 passed, 1 failed
<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="smc test" tests="1" failures="0" errors="1" time="[..]">
  <testsuite name="." tests="1" failures="0" errors="1" skipped="0" time="[..]">
    <testcase name="a&#38;b&#60;'&#62;.smt" classname="cases" time="[..]">
      <error message="line 2: expect takes pass, fail or error">line 2: expect takes pass, fail or error</error>
    </testcase>
  </testsuite>
</testsuites>
-- stderr --
a&b<'>.smt: failed
    line 2: expect takes pass, fail or error
