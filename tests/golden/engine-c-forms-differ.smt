# Emitted C is built in two forms that make every step side by side, with and without flags of what was stored.  One that does something
# else (here a C compiler is imitated that computes wrongly in one of them) is found, and no answer of it is used.
args --version >/dev/null; CC='sh cc.sh' "$SMC" test --engine=ref,c a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
U8 n
[A]
.step
    n = n + 1
-- a.ss --
[options]
delta_t 1
[A]
G == 3: @stop
-- cc.sh --
for source; do :; done
awk '/sv->n = .* 1, 0, UINT8_MAX/ && ++forms == 2 { sub(/ 1, 0,/, " 2, 0,") } { print }' "$source" >edited.c && mv edited.c "$source"
exec cc "$@"
-- stderr --
a.ss:1:1: error: engine c failed: emitted C: with and without --track-stores it does not do the same [E0753]
    1 | [options]
      | ^
1 error
-- exit --
4
