[Safe]
U64  time
U32  state
bool lamp
