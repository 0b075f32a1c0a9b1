# A change that no search and no short proof decides: it makes no difference, and a report counts it as smc mutate does.
args report same.sm same.ss --mutate --format=text | grep -A 1 '^The scripts notice'; "$SMC" mutate same.sm same.ss | head -n 1; "$SMC" mutate same.sm same.ss --generate | head -n 1

-- same.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
[local]
F64 most = 0
[Run]
.step
    most = max(most, p)
    valve = p > 10 and most > 5
-- same.ss --
[all_states]
true: p = 20
at 20: @assert valve
at 50: @stop
-- stdout --
The scripts notice 4 of 11 changes (36.4 %). Changes that make no difference are not counted: 1.
Without `--generate`, `smc mutate` can prove this of fewer changes, and counts the others.
mutations of same: 4 of 11 changes are noticed (36.4 %), and 1 make no difference
mutations of same: 4 of 11 changes are noticed (36.4 %), and 1 make no difference
