# A column is a byte: a tab counts one, a letter outside ASCII in a comment above counts in no other line.
spec 1.7  Lines and columns count from 1, a column is one byte, a tab one column.
args check a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
# grün
[Idle]
.step
		open = nosuch
	open = (1 +	nosuch2)
-- stderr --
a.sm:8:10: error: unknown element 'nosuch' [E0204]
    8 |   open = nosuch
      |          ^~~~~~
a.sm:9:14: error: unknown element 'nosuch2' [E0204]
    9 |  open = (1 + nosuch2)
      |              ^~~~~~~
2 errors
-- exit --
1
