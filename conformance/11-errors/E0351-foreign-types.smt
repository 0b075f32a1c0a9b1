spec 2.1   The types of other languages, and what they are here.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
int e0              #! E0351 did you mean 'I32'?
long e1             #! E0351 did you mean 'I64'?
short e2            #! E0351 did you mean 'I16'?
char e3             #! E0351 did you mean 'I8'?
byte e4             #! E0351 did you mean 'U8'?
unsigned e5         #! E0351 did you mean 'U32'?
uint e6             #! E0351 did you mean 'U32'?
word e7             #! E0351 did you mean 'U16'?
float e8            #! E0351 did you mean 'F32'?
single e9           #! E0351 did you mean 'F32'?
double e10          #! E0351 did you mean 'F64'?
real e11            #! E0351 did you mean 'F64'?
number e12          #! E0351 did you mean 'F64'?
boolean e13         #! E0351 did you mean 'bool'?
Bool e14            #! E0351 did you mean 'bool'?
BOOL e15            #! E0351 did you mean 'bool'?
B e16               #! E0351 did you mean 'bool'?
bit e17             #! E0351 did you mean 'bool'?
i8 e18              #! E0351 did you mean 'I8'?
i16 e19             #! E0351 did you mean 'I16'?
i32 e20             #! E0351 did you mean 'I32'?
i64 e21             #! E0351 did you mean 'I64'?
u8 e22              #! E0351 did you mean 'U8'?
u16 e23             #! E0351 did you mean 'U16'?
u32 e24             #! E0351 did you mean 'U32'?
u64 e25             #! E0351 did you mean 'U64'?
f32 e26             #! E0351 did you mean 'F32'?
f64 e27             #! E0351 did you mean 'F64'?
int8_t e28          #! E0351 did you mean 'I8'?
int16_t e29         #! E0351 did you mean 'I16'?
int32_t e30         #! E0351 did you mean 'I32'?
int64_t e31         #! E0351 did you mean 'I64'?
uint8_t e32         #! E0351 did you mean 'U8'?
uint16_t e33        #! E0351 did you mean 'U16'?
uint32_t e34        #! E0351 did you mean 'U32'?
uint64_t e35        #! E0351 did you mean 'U64'?
int8 e36            #! E0351 did you mean 'I8'?
int16 e37           #! E0351 did you mean 'I16'?
int32 e38           #! E0351 did you mean 'I32'?
int64 e39           #! E0351 did you mean 'I64'?
uint8 e40           #! E0351 did you mean 'U8'?
uint16 e41          #! E0351 did you mean 'U16'?
uint32 e42          #! E0351 did you mean 'U32'?
uint64 e43          #! E0351 did you mean 'U64'?
[Hold]
.step
    x = x + 1
