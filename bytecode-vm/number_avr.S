// SPDX-License-Identifier: Apache-2.0
// The arithmetic of interp_avr.S, which includes this file.  Results equal those of number.h bit for bit, in the registers of interp_avr.S.
//
// Two more names for registers in the comments:
//   a  r25:r18, an F64: the first argument and the result of operations of soft.h
//   n  r21:r18, a 32-bit integer
// All code here preserves Z.
#ifdef STEP

.macro zero_64
	clr r18
	clr r19
	movw r20, r18
	movw r22, r18
	movw r24, r18
.endm

; Calls an operation of soft.h and preserves Z.
.macro soft name
	soft_at \name
	rcall keeping_z
.endm
.macro soft_at name                       ; sets r27:r26 to the address of sm_soft_NAME
	ldi r26, pm_lo8(\name)
	ldi r27, pm_hi8(\name)
.endm
keeping_z:
	push r30
	push r31
	movw r30, r26
	icall
	pop r31
	pop r30
	ret

; ---- from register to register ----

x_to_a:
	movw r18, r2
	movw r20, r4
	movw r22, r6
	movw r24, r8
	ret

a_to_x:
	movw r2, r18
	movw r4, r20
	movw r6, r22
	movw r8, r24
	ori r17, 1
	ret

a_to_y:
	.irp i, 0, 1, 2, 3, 4, 5, 6, 7
	std Y+VM_Y+\i, 18+\i
	.endr
	ori r17, 2
	ret

; Set a to X, Y or n, converted to an F64.
x_to_f64:
	sbrc r17, 0
	rjmp x_to_a
	movw r18, r2
	movw r20, r4
n_to_a:
	movw r22, r18
	movw r24, r20
	soft_at sm_soft_from_i32
	rjmp keeping_z
y_to_a:
	rcall y_as_it_is
	sbrs r17, 1
	rjmp n_to_a
	ret

y_as_it_is:
	.irp i, 0, 1, 2, 3, 4, 5, 6, 7
	ldd 18+\i, Y+VM_Y+\i
	.endr
	ret

from_f32:                                 ; r25:r22
	soft_at sm_soft_from_f32
	rjmp keeping_z

; Converts an I64, or a U64 if type r16 is unsigned.  If the value is a whole number of 32 bits, sets T and returns it in n; else in a.
from_long:
	sbrc r16, 2
	rjmp 1f
	mov r0, r22
	and r0, r23
	and r0, r24
	and r0, r25
	com r0
	brne 1f
	set
	sbrc r21, 7
	ret
1:	soft_at sm_soft_from_i64
	sbrs r16, 2
	rjmp 2f
	soft_at sm_soft_from_u64
2:	rcall keeping_z
	clt
	ret

; Replaces a NaN in a by 0, or by the NaN that a local stores if type r16 is RAW.
no_nan:
	mov r26, r25
	ori r26, 0x80
	cpi r26, 0xFF
	brne 1f
	cpi r24, 0xF0
	brlo 1f
	mov r26, r24
	andi r26, 0x0F
	or r26, r23
	or r26, r22
	or r26, r21
	or r26, r20
	or r26, r19
	or r26, r18
	breq 1f                           ; infinity
	zero_64
	sbrs r16, 1
	ret
	ldi r24, 0xF8
	ldi r25, 0x7F
1:	ret

; ---- truth, relations ----

; r24 = whether X is true: 0 or 1.
x_truth:
	rcall x_to_a
	mov r0, r17
	rjmp truth
y_truth:
	rcall y_as_it_is
	mov r0, r17
	lsr r0
truth:
	sbrc r0, 0
	rjmp 1f
	or r18, r19
	or r18, r20
	or r18, r21
	clr r24
	cpse r18, r1
	ldi r24, 1
	ret
1:	push r26
	push r27
	soft sm_soft_truth
	rjmp restore

; r24 = the relation of X to Y.
relate:
	ldd r18, Y+VM_Y
	ldd r19, Y+VM_Y+1
	ldd r20, Y+VM_Y+2
	ldd r21, Y+VM_Y+3
	tst r17
	brne 2f
	cp r2, r18
	cpc r3, r19
	cpc r4, r20
	cpc r5, r21
	ldi r24, 1
	brlt 1f
	ldi r24, 2
	breq 1f
	ldi r24, 4
1:	ret
2:	push r26
	push r27
	rcall y_to_a
	rcall relate_a
restore:
	pop r27
	pop r26
	ret

relate_n:                                 ; the relation of X to n
	rcall n_to_a
relate_a:
	soft_at sm_soft_relation
; Calls the operation of soft.h at r27:r26 with arguments X and a.
with_a:
	.irp r, 10, 11, 12, 13, 14, 15, 16, 17
	push r\r
	.endr
	bst r17, 0
	movw r10, r18
	movw r12, r20
	movw r14, r22
	movw r16, r24
	brtc 1f
	rcall x_to_a
	rjmp 2f
1:	push r26
	push r27
	rcall x_to_f64_of_whole
	pop r27
	pop r26
2:	rcall keeping_z
	.irp r, 17, 16, 15, 14, 13, 12, 11, 10
	pop r\r
	.endr
	ret
x_to_f64_of_whole:
	movw r18, r2
	movw r20, r4
	rjmp n_to_a

; ---- conversion for stores ----

; Converts X to type r16, in r25:r18: an integer or bool as 64 bits, an F32 as its 32 bits, or an F64.
convert:
	sbrc r16, 3
	rjmp 5f
	movw r18, r2
	movw r20, r4
	sbrs r17, 0
	rjmp clip
	push r30
	push r31
	rcall x_to_a
	cpi r16, 3
	breq 2f
	cpi r16, 6
	breq 3f
	cpi r16, 7
	breq 4f
	xcall sm_soft_to_i32
	rcall 6f
	pop r31
	pop r30
	rjmp clip
2:	xcall sm_soft_to_i64
	rjmp converted
4:	xcall sm_soft_to_u64
	rjmp converted
3:	xcall sm_soft_to_u32
	rcall 6f
converted:
	pop r31
	pop r30
	ret
6:	movw r18, r22                     ; soft.h returns 32-bit results in r25:r22
	movw r20, r24
	clr r22
	clr r23
	movw r24, r22
	ret
5:	sbrc r16, 0
	rjmp 7f
	sbrc r16, 1
	rjmp 8f
	rcall x_to_f64
	rcall no_nan
	soft sm_soft_to_f32
	rjmp 6b
7:	rcall x_to_f64                    ; F64, RAW
	rjmp no_nan
8:	rcall x_truth
	mov r18, r24
	clr r19
	clr r20
	clr r21
	ret

; Clips n to type r16, as 64 bits.
clip:
	clr r0                            ; the value of the upper bytes
	sbrs r21, 7
	rjmp 1f
	sbrc r16, 2
	rjmp 5f                           ; n is below 0
	com r0
1:	sbrc r16, 1
	rjmp 4f                           ; 32 or 64 bits: it fits
	mov r24, r18                      ; the byte with the sign of the type
	cp r20, r0
	cpc r21, r0
	brne 2f
	sbrc r16, 0
	mov r24, r19
	sbrs r16, 0
	cp r19, r0
	brne 2f
	eor r24, r0
	sbrc r24, 7
	sbrc r16, 2
	rjmp 4f
2:	mov r18, r0                       ; out of range: all ones or zeros except for the highest bit
	com r18
	mov r19, r0
	sbrc r16, 0
	mov r19, r18
	mov r20, r0
	mov r21, r0
	sbrc r16, 2
	rjmp 4f
	ldi r24, 0x80
	sbrs r16, 0
	eor r18, r24
	sbrc r16, 0
	eor r19, r24
4:	mov r22, r0
	mov r23, r0
	movw r24, r22
	ret
5:	zero_64
	ret

; ---- add ... or ----

compute:                                  ; runs the opcodes from 0xF0 on
	cpi r16, 0xF8
	brlo 1f
	rjmp of_one
1:	cpi r16, 0xF4
	brlo arithmetic
	cpi r16, 0xF6
	brlo choose

; Runs `and` and `or`.
both:
	rcall x_truth
	push r24
	rcall y_truth
	pop r25
	sbrs r16, 0
	and r24, r25
	sbrc r16, 0
	or r24, r25
	rjmp truth_x

; Runs `min` and `max`.
choose:
	rcall relate
	sbrc r24, 3
	rjmp not_a_number
	sbrc r24, 1
	rjmp 1f
	eor r24, r16
	sbrs r24, 0
	rjmp 3f
	rjmp next
1:	ldd r24, Y+VM_Y+7                 ; equal: for zeros min returns -0, max +0
	mov r25, r17
	lsr r25
	sbrs r16, 0
	rjmp 2f
	mov r24, r9
	mov r25, r17
2:	sbrc r24, 7
	sbrs r25, 0
	rjmp next
3:	.irp i, 2, 3, 4, 5, 6, 7, 8, 9
	ldd \i, Y+VM_Y+\i-2
	.endr
	bst r17, 1
	bld r17, 0
	rjmp next
not_a_number:
	ldi r24, 0xF8
	ldi r25, 0x7F
	movw r8, r24
	ori r17, 1
	rjmp next

arithmetic:                               ; add, sub, mul, div
	ldd r18, Y+VM_Y
	ldd r19, Y+VM_Y+1
	ldd r20, Y+VM_Y+2
	ldd r21, Y+VM_Y+3
	sbrc r17, 1
	rjmp with_y
	cpi r16, 0xF2
	brlo plus
	brne with_y
	sbrs r17, 0
	rjmp product
with_y:
	rcall y_to_a
	cpi r16, 0xF2
	brlo sum
	soft_at sm_soft_mul
	breq operate
	soft_at sm_soft_div
	rjmp operate

; X = X + n, or X - n if the opcode is odd.
plus:
	sbrc r17, 0
	rjmp 2f
	movw r24, r2
	movw r26, r4
	sbrc r16, 0
	rjmp 1f
	add r24, r18
	adc r25, r19
	adc r26, r20
	adc r27, r21
	brvs 2f
	rjmp taken
1:	sub r24, r18
	sbc r25, r19
	sbc r26, r20
	sbc r27, r21
	brvs 2f
taken:
	movw r2, r24
	movw r4, r26
	rjmp next
2:	rcall n_to_a
sum:
	soft_at sm_soft_add
	sbrs r16, 0
	rjmp operate
	soft_at sm_soft_sub
operate:
	rcall with_a
	rjmp given_x

; Multiplies whole numbers of 16 bits.  A zero product that may be -0 is left to sm_soft_mul.
product:
	mov r24, r3
	lsl r24
	sbc r24, r24
	cp r4, r24
	cpc r5, r24
	brne 1f
	mov r24, r19
	lsl r24
	sbc r24, r24
	cp r20, r24
	cpc r21, r24
	brne 1f
	movw r22, r2
	clr r20
	muls r23, r19
	movw r26, r0
	mul r22, r18
	movw r24, r0
	mulsu r23, r18
	sbc r27, r20
	add r25, r0
	adc r26, r1
	adc r27, r20
	mulsu r19, r22
	sbc r27, r20
	add r25, r0
	adc r26, r1
	adc r27, r20
	clr r1
	mov r0, r24
	or r0, r25
	or r0, r26
	or r0, r27
	brne 2f
	or r19, r23
	brmi 1f
2:	rjmp taken
1:	rjmp with_y

; ---- neg ... sign ----

of_one:
	cpi r16, 0xFF
	breq sign
	sbrc r17, 0
	rjmp of_real
	cpi r16, 0xFE
	breq 2f
	cpi r16, 0xFA
	brsh 3f                           ; floor ... round: X is whole already
	sbrs r16, 0
	rjmp 1f
	sbrs r5, 7
	rjmp next                         ; abs
1:	clr r18
	clr r19
	movw r20, r18
	sub r18, r2
	sbc r19, r3
	sbc r20, r4
	sbc r21, r5
	breq 2f                           ; would be -0
	brvs 2f
	rjmp whole_x
2:	rcall x_to_f64
	rcall a_to_x
	rjmp of_real
3:	rjmp next

sign:
	mov r25, r5
	sbrc r17, 0
	mov r25, r9
	push r25
	rcall x_truth
	pop r25
	tst r24
	breq 3b                           ; 0 or NaN
	ldi r18, 1
	clr r19
	sbrs r25, 7
	rjmp 1f
	ldi r18, 0xFF
	mov r19, r18
1:	mov r20, r19
	mov r21, r19
	rjmp whole_x

of_real:
	ldi r24, 0x80
	cpi r16, 0xF9
	brlo 1f
	breq 2f
	cpi r16, 0xFE
	brne round
	rjmp root
1:	eor r9, r24
	rjmp next
2:	com r24
	and r9, r24
	rjmp next

; Runs `floor`, `ceil`, `trunc` and `round` for an X that is an F64.
round:
	movw r24, r8
	andi r25, 0x7F
	cpi r24, 0x30
	ldi r26, 0x43
	cpc r25, r26
	brsh 3b                           ; no fraction, infinity or NaN
	cpi r16, 0xFD
	brne 1f
	ldi r26, 0xFF                     ; the largest number below 0.5: the sum reaches the next whole number from a fraction of 0.5 on
	ldi r24, 0xDF
	rcall add_further
	rcall a_to_x
1:	rcall x_to_a
	soft sm_soft_to_i64
	soft sm_soft_from_i64
	bst r9, 7
	bld r25, 7
	cpi r16, 0xFC
	brsh 2f
	cp r18, r2
	cpc r19, r3
	cpc r20, r4
	cpc r21, r5
	cpc r22, r6
	cpc r23, r7
	cpc r24, r8
	cpc r25, r9
	breq 3f
	clr r26                           ; floor adjusts negative numbers, ceil positive ones
	bld r26, 0
	eor r26, r16
	sbrs r26, 0
	rjmp 2f
	rcall a_to_x
	clr r26
	ldi r24, 0xF0
	rcall add_further
2:	rjmp given_x
3:	rjmp next

; a = X + c with the sign of X.  The bytes of c are 0x3F, then r24, then r26 for all others.
add_further:
	ldi r25, 0x3F
	bst r9, 7
	bld r25, 7
	mov r18, r26
	mov r19, r26
	movw r20, r18
	movw r22, r18
	soft_at sm_soft_add
	rjmp with_a

; Runs `sqrt`: computes the root one bit at a time.
root:
	rcall x_truth
	tst r24
	breq 3b                           ; 0 or NaN
	sbrc r9, 7
	rjmp not_a_number
	movw r24, r8
	cpi r24, 0xF0
	ldi r26, 0x7F
	cpc r25, r26
	brsh 3b                           ; infinity
	.irp r, 10, 11, 12, 13, 14, 15, 30, 31
	push r\r
	.endr
	rcall x_to_a
	movw r30, r24                     ; the exponent
	.rept 4
	lsr r31
	ror r30
	.endr
	andi r24, 0x0F
	sbiw r30, 0
	breq 1f
	ori r24, 0x10
	rjmp 3f
1:	adiw r30, 1
2:	sbiw r30, 1
	rcall double_a
	sbrs r24, 4
	rjmp 2b
3:	subi r30, lo8(-1023)
	sbci r31, hi8(-1023)
	rcall double_a
	sbrc r30, 0
	rcall double_a
	clr r10                           ; r16:r10  twice the root
	clr r11
	movw r12, r10
	movw r14, r10
	clr r16
	movw r2, r10                      ; r8:r2  the current bit
	movw r4, r10
	movw r6, r10
	ldi r25, 0x20
	mov r8, r25
4:	or r10, r2
	or r11, r3
	or r12, r4
	or r13, r5
	or r14, r6
	or r15, r7
	or r16, r8
	cp r18, r10
	cpc r19, r11
	cpc r20, r12
	cpc r21, r13
	cpc r22, r14
	cpc r23, r15
	cpc r24, r16
	brlo 5f
	sub r18, r10
	sbc r19, r11
	sbc r20, r12
	sbc r21, r13
	sbc r22, r14
	sbc r23, r15
	sbc r24, r16
	add r10, r2
	adc r11, r3
	adc r12, r4
	adc r13, r5
	adc r14, r6
	adc r15, r7
	adc r16, r8
	rjmp 6f
5:	eor r10, r2
	eor r11, r3
	eor r12, r4
	eor r13, r5
	eor r14, r6
	eor r15, r7
	eor r16, r8
6:	rcall double_a
	lsr r8
	ror r7
	ror r6
	ror r5
	ror r4
	ror r3
	ror r2
	brcc 4b
	ldi r25, 2                        ; rounds: the root has one bit more than fits, and a tie is impossible
	add r10, r25
	adc r11, r1
	adc r12, r1
	adc r13, r1
	adc r14, r1
	adc r15, r1
	adc r16, r1
	ldi r25, 2
7:	lsr r16
	ror r15
	ror r14
	ror r13
	ror r12
	ror r11
	ror r10
	dec r25
	brne 7b
	andi r16, 0x0F
	lsr r31
	ror r30
	.rept 4
	lsl r30
	rol r31
	.endr
	or r30, r16
	movw r2, r10
	movw r4, r12
	movw r6, r14
	movw r8, r30
	.irp r, 31, 30, 15, 14, 13, 12, 11, 10
	pop r\r
	.endr
	rjmp next

double_a:                                 ; shifts the lower seven bytes of a
	lsl r18
	rol r19
	rol r20
	rol r21
	rol r22
	rol r23
	rol r24
	ret

#endif
