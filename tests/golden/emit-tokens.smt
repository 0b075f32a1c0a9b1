# --emit=tokens
args build --emit=tokens a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
# Tokens of a.sm, printed by smc
1:1	header	[state_vector]
2:1	type	U64
2:5	name	G
3:1	type	U32
3:5	name	S
4:1	type	bool
4:6	name	open
5:1	header	[Idle]
6:1	label	.step
7:5	name	open
7:10	=	=
7:12	true	true
8:1	end	
