# Emitted C does not start where the C compiler gives arithmetic another meaning (imitated here by another number in its self-test).
args --version >/dev/null; CC='sh cc.sh' "$SMC" test --engine=ref,c a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x
[A]
.step
    x = x / 3
-- a.ss --
[options]
delta_t 1
[A]
G == 3: @stop
-- cc.sh --
for source; do :; done
sed 's/ three = 3.0,/ three = 3.5,/' "$source" >edited.c && mv edited.c "$source"
exec cc "$@"
-- stderr --
smc: engine c: emitted C: it does not start: the C compiler or its options change what arithmetic means
-- exit --
3
