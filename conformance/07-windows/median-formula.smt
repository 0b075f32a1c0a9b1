spec 7.16  Pairs for which (a + b) / 2 or a / 2 + b / 2 would give another last bit.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 median
F64 p

[Run]
.step
    median = roll_median(p, 2)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = -0.28456713888301954
G == 1: p = 0.7557932554369812
G == 2: p = -0.5411444924025169
G == 3: p = 65.15414201308461
G == 4: p = -0.5115662762768215
G == 5: p = 0.933175499455442
G == 6: p = -0.6546968742253276
G == 7: p = 6.637805964255711
G == 7: @stop

-- trace --
1 median -0x1.2365916c134fcp-2
2 median 0x1.e289195e7b3dp-3
3 median 0x1.b799c54ae1078p-4
4 median 0x1.0273b59f3f6f5p+5
5 median 0x1.0291ff5fbb2b9p+5
6 median 0x1.afba5404f9ffcp-3
7 median 0x1.1d29802ffe57cp-3
8 median 0x1.7eeb4263852c1p+1
