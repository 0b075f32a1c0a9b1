# What cannot be read or written is an error in JUnit XML, with the system's reason.
args test a.sm missing.ss good.ss --junit=script.xml
args test missing.sm good.ss --junit=machine.xml
args test a.sm good.ss --sv=missing.sv --junit=vector.xml
args test a.sm good.ss --trace=no/such.csv --junit=trace.xml
args --version >/dev/null; grep '<error' script.xml machine.xml vector.xml trace.xml

-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- good.ss --
[options]
delta_t 10
[all_states]
G == 0 {
    @assert S == 1
    @stop
}
-- stdout --
1 passed, 1 failed
script.xml:      <error message="cannot read 'missing.ss': No such file or directory">cannot read 'missing.ss': No such file or directory</error>
machine.xml:      <error message="cannot read 'missing.sm': No such file or directory">cannot read 'missing.sm': No such file or directory</error>
vector.xml:      <error message="cannot read 'missing.sv': No such file or directory">cannot read 'missing.sv': No such file or directory</error>
trace.xml:      <error message="cannot write 'no/such.csv': No such file or directory">cannot write 'no/such.csv': No such file or directory</error>
-- stderr --
smc: cannot read 'missing.ss': No such file or directory
smc: cannot read 'missing.sm': No such file or directory
smc: cannot read 'missing.sv': No such file or directory
smc: cannot write 'no/such.csv': No such file or directory
-- exit --
3 3 3 3 0
