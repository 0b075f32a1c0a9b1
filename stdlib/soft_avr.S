// SPDX-License-Identifier: Apache-2.0
// Software binary64 for AVR with a multiplier (soft.h).  Its results have the same bits as those of soft_arith.c and soft_convert.c.  It is
// about ten times as fast as their code compiled by avr-gcc.
//
// The calling convention of avr-gcc: a is in r25:r18, b in r17:r10.  A result is in r25:r18, one of 32 bits in r25:r22,
// one of 8 bits in r24.  A function may change r18 to r27, r30, r31, r0 and the flag T; r1 is 0.
//
// Inside an operation:
//   r24:r18  the significand of a as in binary64, with its leading bit, which is not stored, at bit 4 of r24
//   r16:r10  that of b
//   r27      the eight bits below r18; the lowest is sticky: also set if a nonzero bit was below it
//   r31:r30  the exponent; where comments call it scaled, times 16, as in the upper two bytes of a number
//   T        the sign
#include "stdlib/soft_pack.h"

#ifdef SM_SOFT_ASSEMBLY

.macro function name
	.global \name
	.type \name, @function
\name:
.endm

; ---- compare ----

	.section .text.sm_soft_compare, "ax", @progbits

; Compares a and b.  r24 is -1 if a is less, 0 if equal, 1 if greater, 2 if one is NaN; the flags are those of `tst r24`.
compare:
	mov r26, r24
	mov r27, r25
	lsl r26
	rol r27
	ldi r30, 0xFF
	cpi r26, 0xE0
	cpc r27, r30
	brsh .Lcheck_a                    ; infinity or NaN
.Lcheck_b:
	mov r26, r16
	mov r27, r17
	lsl r26
	rol r27
	cpi r26, 0xE0
	cpc r27, r30
	brsh .Lcheck_b_nan
.Lnumbers:
	mov r26, r25
	eor r26, r17
	brmi .Lsigns
	cp r18, r10
	cpc r19, r11
	cpc r20, r12
	cpc r21, r13
	cpc r22, r14
	cpc r23, r15
	cpc r24, r16
	cpc r25, r17
	breq .Lequal
	sbc r24, r24                      ; -1 if a is below b as integers
	sbrc r25, 7
	com r24
	ori r24, 1
	ret
.Lequal:
	clr r24
	ret
.Lsigns:                                  ; of different signs, but 0 equals -0
	mov r26, r25
	or r26, r17
	lsl r26
	or r26, r24
	or r26, r16
	or r26, r23
	or r26, r15
	or r26, r22
	or r26, r14
	or r26, r21
	or r26, r13
	or r26, r20
	or r26, r12
	or r26, r19
	or r26, r11
	or r26, r18
	or r26, r10
	breq .Lequal
	ldi r24, 1
	sbrc r25, 7
	ldi r24, 0xFF
	tst r24
	ret
.Lcheck_a:
	subi r26, 0xE0
	or r26, r23
	or r26, r22
	or r26, r21
	or r26, r20
	or r26, r19
	or r26, r18
	breq .Lcheck_b
.Lnan:
	ldi r24, 2
	tst r24
	ret
.Lcheck_b_nan:
	subi r26, 0xE0
	or r26, r15
	or r26, r14
	or r26, r13
	or r26, r12
	or r26, r11
	or r26, r10
	brne .Lnan
	rjmp .Lnumbers

function sm_soft_relation
	rcall compare
	mov r25, r24
	ldi r24, 2
	breq .Lsaid
	ldi r24, 1
	brmi .Lsaid
	ldi r24, 4
	sbrc r25, 1
	ldi r24, 8
.Lsaid:
	ret

function sm_soft_lt
	rcall compare
	rol r24                           ; its sign
	rol r24
	andi r24, 1
	ret

function sm_soft_eq
	rcall compare
	breq .Lyes
	clr r24
	ret
.Lyes:
	ldi r24, 1
	ret

function sm_soft_le
	rcall compare
	breq .Lyes
	rol r24
	rol r24
	andi r24, 1
	ret

function sm_soft_is_nan
	mov r26, r24
	lsl r26
	rol r25
	ldi r27, 0xFF
	cpi r26, 0xE0
	cpc r25, r27
	clr r24
	brlo .Lanswer
	subi r26, 0xE0
	or r26, r23
	or r26, r22
	or r26, r21
	or r26, r20
	or r26, r19
	or r26, r18
	breq .Lanswer
	ldi r24, 1
.Lanswer:
	ret

function sm_soft_truth
	lsl r25
	mov r26, r25
	or r26, r24
	or r26, r23
	or r26, r22
	or r26, r21
	or r26, r20
	or r26, r19
	or r26, r18
	breq .Lno
	lsr r25
	rcall sm_soft_is_nan
	ldi r25, 1
	eor r24, r25
	ret
.Lno:
	clr r24
	ret

; ---- rounding and packing ----

	.section .text.sm_soft_arith, "ax", @progbits

; Shifts the significand of a right by one.  The lowest bit of r27 is sticky.
.macro one_down
	lsr r24
	ror r23
	ror r22
	ror r21
	ror r20
	ror r19
	ror r18
	ror r27
	brcc 7f
	ori r27, 1
7:
.endm

; Rounds and packs a.  The exponent is not scaled and can have any value; the leading bit is at bit 4 of r24.
finish:
	cp r1, r30
	cpc r1, r31
	brlt 3f
	; Below the smallest exponent: shift right until the exponent is 1.
	subi r30, 1
	sbci r31, 0
	cpi r30, 0xC9                     ; -55
	ldi r26, 0xFF
	cpc r31, r26
	brlt .Lzero                       ; less than a quarter of the lowest bit
1:	one_down
	inc r30
	brne 1b
	clr r31
	ldi r30, 1
3:	cpi r30, 0xFF
	ldi r26, 0x07
	cpc r31, r26
	brge .Linfinity
.Lx16:
	swap r31
	swap r30
	mov r26, r30
	andi r26, 0x0F
	or r31, r26
	andi r30, 0xF0
; Rounds and packs a.  The exponent is scaled and within its range; if it is 1, the lowest, the leading bit may be lower.
finish16:
	cpi r27, 0x80
	brlo 2f
	brne 1f
	sbrs r18, 0                       ; a tie: round to even
	rjmp 2f
1:	sec
	adc r18, r1
	adc r19, r1
	adc r20, r1
	adc r21, r1
	adc r22, r1
	adc r23, r1
	adc r24, r1
; The leading bit adds one to the exponent, so one is subtracted first.  A carry from rounding adds one too.
2:	subi r30, 0x10
	sbci r31, 0
	mov r25, r31
	add r24, r30
	adc r25, r1
	bld r25, 7
	ret
.Lzero:
	clr r25
	rjmp 1f
.Linfinity:
	ldi r24, 0xF0
	ldi r25, 0x7F
	rjmp 2f
1:	clr r24
2:	clr r23
	clr r22
	clr r21
	clr r20
	clr r19
	clr r18
	bld r25, 7
	ret
.Lnot_a_number:
	rcall .Linfinity
	ldi r24, 0xF8
	ldi r25, 0x7F
	ret

down:
	one_down
	ret

; Clears flag Z if any bit of the significand of a is set.
any_of_a:
	mov r0, r24
	or r0, r23
	or r0, r22
	or r0, r21
	or r0, r20
	or r0, r19
	or r0, r18
	ret

; ---- add, subtract ----

function sm_soft_sub
	push r17
	subi r17, 0x80
	rjmp .Ladd

function sm_soft_add
	push r17
.Ladd:
	push r16
	push r15
	push r14
	push r13
	push r12
	push r11
	push r10
	rcall add
	pop r10
	pop r11
	pop r12
	pop r13
	pop r14
	pop r15
	pop r16
	pop r17
	ret

.macro exchange a, b
	mov r0, \a
	mov \a, \b
	mov \b, r0
.endm

add:
	bst r25, 7
	mov r26, r25
	eor r26, r17                      ; bit 7: the signs differ
	andi r25, 0x7F
	andi r17, 0x7F
	cp r18, r10
	cpc r19, r11
	cpc r20, r12
	cpc r21, r13
	cpc r22, r14
	cpc r23, r15
	cpc r24, r16
	cpc r25, r17
	brsh 1f
	exchange r18, r10                 ; |a| must be the larger; the result has its sign
	exchange r19, r11
	exchange r20, r12
	exchange r21, r13
	exchange r22, r14
	exchange r23, r15
	exchange r24, r16
	exchange r25, r17
	sbrs r26, 7
	rjmp 1f
	bld r27, 0
	com r27
	bst r27, 0
1:	mov r31, r25
	mov r30, r24
	andi r30, 0xF0
	mov r27, r16
	andi r27, 0xF0
	cpi r30, 0xF0
	ldi r25, 0x7F
	cpc r31, r25
	brne 2f
	rjmp .Ladd_special
2:	andi r24, 0x0F
	andi r16, 0x0F
	mov r25, r31
	or r25, r30
	breq 3f
	ori r24, 0x10
	rjmp 4f
.Lb_is_nothing:
	clr r27
	rjmp finish16
3:	ldi r30, 0x10                     ; no leading bit, and the exponent is that of 1
4:	mov r25, r17
	or r25, r27
	breq 5f
	ori r16, 0x10
	rjmp 6f
5:	ldi r27, 0x10
; Computes how far b must be shifted right, from the difference of the exponents.
6:	mov r25, r30
	sub r25, r27
	mov r0, r31
	sbc r0, r17
	mov r17, r0
	clr r27
	or r0, r25
	breq .Laligned
	cpi r17, 4
	brsh .Lb_is_nothing
	swap r17
	swap r25
	or r25, r17
	cpi r25, 56
	brsh .Lb_is_nothing
	clr r0                            ; collects the bits that are shifted out
	mov r17, r25
	andi r17, 7
	cpi r17, 5
	brlo .Lbytes
; A shift right by 5, 6 or 7 bits: left by 3, 2 or 1, then right by one more byte.
1:	lsl r10
	rol r11
	rol r12
	rol r13
	rol r14
	rol r15
	rol r16
	inc r25
	inc r17
	cpi r17, 8
	brlo 1b
	clr r17
.Lbytes:
	subi r25, 8
	brcs 2f
1:	or r0, r27
	mov r27, r10
	mov r10, r11
	mov r11, r12
	mov r12, r13
	mov r13, r14
	mov r14, r15
	mov r15, r16
	clr r16
	subi r25, 8
	brcc 1b
2:	tst r17
	breq 4f
	ldi r25, 1
3:	lsr r16
	ror r15
	ror r14
	ror r13
	ror r12
	ror r11
	ror r10
	ror r27
	brcc 5f
	or r0, r25
5:	dec r17
	brne 3b
4:	cpse r0, r1
	ori r27, 1
.Laligned:
	sbrc r26, 7
	rjmp .Lless
	add r18, r10
	adc r19, r11
	adc r20, r12
	adc r21, r13
	adc r22, r14
	adc r23, r15
	adc r24, r16
	sbrs r24, 5
	rjmp finish16
	rcall down                        ; the sum has a bit above the leading bit
	subi r30, 0xF0
	sbci r31, 0xFF
	cpi r30, 0xF0
	ldi r26, 0x7F
	cpc r31, r26
	breq 2f
	rjmp finish16
2:	rjmp .Linfinity
.Lless:
	neg r27
	sbc r18, r10
	sbc r19, r11
	sbc r20, r12
	sbc r21, r13
	sbc r22, r14
	sbc r23, r15
	sbc r24, r16
	sbrc r24, 4
	rjmp finish16
	tst r24
	brne .Lup                         ; leading bits were cancelled: normalize
	mov r26, r27
	or r26, r18
	or r26, r19
	or r26, r20
	or r26, r21
	or r26, r22
	or r26, r23
	brne 1f
	clt                               ; the difference is 0, not -0
	rjmp .Lzero
1:	tst r24
	brne .Lup
	cpi r23, 0x20
	brsh .Lup
	cpi r30, 0x90
	cpc r31, r1
	brlo .Lup
	subi r30, 0x80
	sbci r31, 0
	mov r24, r23
	mov r23, r22
	mov r22, r21
	mov r21, r20
	mov r20, r19
	mov r19, r18
	mov r18, r27
	clr r27
	rjmp 1b
.Lup:
	sbrc r24, 4
	rjmp finish16
	cpi r30, 0x10
	cpc r31, r1
	breq 2f                           ; the smallest exponent: the result stays subnormal
	subi r30, 0x10
	sbci r31, 0
	lsl r27
	rol r18
	rol r19
	rol r20
	rol r21
	rol r22
	rol r23
	rol r24
	rjmp .Lup
2:	rjmp finish16

.Ladd_special:                            ; a is infinite or NaN; |b| is not above |a|
	andi r24, 0x0F
	rcall any_of_a
	brne 1f
	cpi r27, 0xF0                     ; a is infinite: is b infinite, too?
	cpc r17, r25
	brne 2f
	sbrc r26, 7
1:	rjmp .Lnot_a_number
2:	rjmp .Linfinity

; ---- unpacking for multiplication and division ----

; Unpacks a and b: exponents to r31:r30 and r29:r28, not scaled, the sign of the result to T.  Sets carry if one is not a finite
; nonzero number.  Then r26 for a and r27 for b are 0 for such a number, 1 for zero, 2 for infinity, 4 for NaN.
take_apart:
	mov r26, r25
	eor r26, r17
	bst r26, 7
	mov r30, r24
	mov r31, r25
	andi r31, 0x7F
	rcall .Lexponent
	movw r28, r30
	mov r30, r16
	mov r31, r17
	andi r31, 0x7F
	rcall .Lexponent
	movw r26, r30
	movw r30, r28
	movw r28, r26
	andi r24, 0x0F
	andi r16, 0x0F
	clr r26
	clr r27
	; a
	mov r0, r31
	or r0, r30
	breq .La_small
	cpi r30, 0xFF
	ldi r25, 0x07
	cpc r31, r25
	breq .La_large
	ori r24, 0x10
.Ltake_b:
	mov r0, r29
	or r0, r28
	breq .Lb_small
	cpi r28, 0xFF
	ldi r25, 0x07
	cpc r29, r25
	breq .Lb_large
	ori r16, 0x10
.Ltaken:
	mov r0, r26
	or r0, r27
	cp r1, r0                         ; carry unless both are 0
	ret
.La_large:
	ldi r26, 4
	rcall any_of_a
	brne .Ltake_b
	ldi r26, 2
	rjmp .Ltake_b
.Lb_large:
	ldi r27, 4
	rcall any_of_b
	brne .Ltaken
	ldi r27, 2
	rjmp .Ltaken
.La_small:
	rcall any_of_a
	ldi r26, 1
	breq .Ltake_b
	clr r26
	adiw r30, 1
1:	sbiw r30, 1
	lsl r18
	rol r19
	rol r20
	rol r21
	rol r22
	rol r23
	rol r24
	sbrs r24, 4
	rjmp 1b
	rjmp .Ltake_b
.Lb_small:
	rcall any_of_b
	ldi r27, 1
	breq .Ltaken
	clr r27
	adiw r28, 1
1:	sbiw r28, 1
	lsl r10
	rol r11
	rol r12
	rol r13
	rol r14
	rol r15
	rol r16
	sbrs r16, 4
	rjmp 1b
	rjmp .Ltaken

any_of_b:
	mov r0, r16
	or r0, r15
	or r0, r14
	or r0, r13
	or r0, r12
	or r0, r11
	or r0, r10
	ret

.Lexponent:                               ; extracts it from the upper bytes of a number without sign
	swap r30
	andi r30, 0x0F
	swap r31
	mov r27, r31
	andi r27, 0xF0
	or r30, r27
	andi r31, 0x0F
	ret

; ---- multiply, divide ----

.macro save
	push r10
	push r11
	push r12
	push r13
	push r14
	push r15
	push r16
	push r17
	push r28
	push r29
.endm

.Lrestore:
	pop r29
	pop r28
	pop r17
	pop r16
	pop r15
	pop r14
	pop r13
	pop r12
	pop r11
	pop r10
	ret

function sm_soft_mul
	save
	rcall multiply
	rjmp .Lrestore

function sm_soft_div
	save
	rcall divide
	rjmp .Lrestore

; Adds all products of two bytes whose lower byte is byte k of the result.
.macro column k, low, mid, high
	.set i, 0
	.rept 7
	.if (\k - i >= 0) && (\k - i < 7)
	mul 18 + i, 10 + \k - i
	add \low, r0
	adc \mid, r1
	adc \high, r17
	.endif
	.set i, i + 1
	.endr
.endm

multiply:
	rcall take_apart
	brcc 1f
	or r26, r27
	cpi r26, 2
	brlo 2f
	breq 3f
	rjmp .Lnot_a_number
2:	rjmp .Lzero
3:	rjmp .Linfinity
1:	add r30, r28
	adc r31, r29
	subi r30, lo8(1023)
	sbci r31, hi8(1023)
	.rept 3
	lsl r18
	rol r19
	rol r20
	rol r21
	rol r22
	rol r23
	rol r24
	.endr
; The upper 7 of 14 bytes replace those of a as soon as these are not needed any more.  Byte 6 is below them.  The other bytes only set the
; sticky bit.
	clr r17
	clr r25
	clr r28
	clr r29
	column 0, r25, r28, r29
	mov r26, r25
	clr r25
	column 1, r28, r29, r25
	or r26, r28
	clr r28
	column 2, r29, r25, r28
	or r26, r29
	clr r29
	column 3, r25, r28, r29
	or r26, r25
	clr r25
	column 4, r28, r29, r25
	or r26, r28
	clr r28
	column 5, r29, r25, r28
	or r26, r29
	clr r29
	column 6, r25, r28, r29
	mov r27, r25
	clr r25
	column 7, r28, r29, r25
	mov r18, r28
	clr r28
	column 8, r29, r25, r28
	mov r19, r29
	clr r29
	column 9, r25, r28, r29
	mov r20, r25
	clr r25
	column 10, r28, r29, r25
	mov r21, r28
	clr r28
	column 11, r29, r25, r28
	mov r22, r29
	clr r29
	column 12, r25, r28, r29
	mov r23, r25
	mov r24, r28
	clr r1
	cpse r26, r1
	ori r27, 1
	sbrs r24, 4
	rjmp 4f
	adiw r30, 1
	rjmp finish
4:	lsl r27
	rol r18
	rol r19
	rol r20
	rol r21
	rol r22
	rol r23
	rol r24
	rjmp finish

.macro take_b_off
	sub r18, r10
	sbc r19, r11
	sbc r20, r12
	sbc r21, r13
	sbc r22, r14
	sbc r23, r15
	sbc r24, r16
.endm

.macro compare_with_b
	cp r18, r10
	cpc r19, r11
	cpc r20, r12
	cpc r21, r13
	cpc r22, r14
	cpc r23, r15
	cpc r24, r16
.endm

.macro double_a
	lsl r18
	rol r19
	rol r20
	rol r21
	rol r22
	rol r23
	rol r24
.endm

divide:
	rcall take_apart
	brcc 1f
	cp r26, r27
	breq 2f
	cpi r26, 4
	breq 2f
	cpi r27, 4
	breq 2f
	cpi r26, 2
	breq 3f
	cpi r27, 1
	breq 3f
	rjmp .Lzero
2:	rjmp .Lnot_a_number
3:	rjmp .Linfinity
1:	sub r30, r28
	sbc r31, r29
	subi r30, lo8(-1023)
	sbci r31, hi8(-1023)
	compare_with_b
	brsh 4f
	double_a
	sbiw r30, 1
4:	mov r25, r14                      ; has the significand of b at most 16 bits?
	andi r25, 0x1F
	or r25, r13
	or r25, r12
	or r25, r11
	or r25, r10
	breq short
	ldi r26, 7                        ; bytes of the result; the upper one has 6 bits
	ldi r25, 6
	clr r0
	com r0
; The bits of the quotient enter r0 inverted.  Usually the first byte decides the comparison.
5:	cp r24, r16
	brlo 6f
	brne 9f
	compare_with_b
	brcs 6f
9:	take_b_off
6:	rol r0
	double_a
	dec r25
	brne 5b
	com r0
	push r0
	ldi r25, 8
	dec r26
	brne 5b
	clr r27
divided:                                  ; appends the sticky bit, and restores one bit of position
	rcall any_of_a
	breq 8f
	ldi r27, 1
8:	pop r18
	pop r19
	pop r20
	pop r21
	pop r22
	pop r23
	pop r24
	rcall down
	rjmp finish

; Divides by b with a significand of 16 bits, as in most whole numbers, one byte of the result at a time.  The significand of b is in
; r16:r15, with its leading bit at bit 7.  The remainder of a is below b, in r24:r23, and the next byte in r22.
short:
	ldi r26, 3
1:	lsl r14
	rol r15
	rol r16
	dec r26
	brne 1b
; r26 = 256 (1 / (1 - t) - 1), or slightly less, with 256 (1 - t) = r16 + 1; computed as t + t (t + t (t + ...)).
	mov r17, r16
	com r17
	mov r26, r17
	ldi r27, 6
1:	mul r26, r17
	mov r26, r17
	add r26, r1
	dec r27
	brne 1b
	clr r17
	ldi r27, 7
2:	mul r24, r26                      ; a lower bound of the byte, usually one or two below it
	add r1, r24
	mov r25, r1
	mul r25, r15
	sub r22, r0
	sbc r23, r1
	sbc r24, r17
	mul r25, r16
	sub r23, r0
	sbc r24, r1
3:	cp r22, r15
	cpc r23, r16
	cpc r24, r17
	brlo 4f
	sub r22, r15
	sbc r23, r16
	sbc r24, r17
	inc r25
	rjmp 3b
4:	push r25
	mov r24, r23
	mov r23, r22
	mov r22, r21
	mov r21, r20
	mov r20, r19
	mov r19, r18
	clr r18
	dec r27
	brne 2b
	clr r1
	rjmp divided

; ---- from integers and binary32 ----

function sm_soft_from_i64
	bst r25, 7
	brtc 1f
	com r25
	com r24
	com r23
	com r22
	com r21
	com r20
	com r19
	neg r18
	sbci r19, 0xFF
	sbci r20, 0xFF
	sbci r21, 0xFF
	sbci r22, 0xFF
	sbci r23, 0xFF
	sbci r24, 0xFF
	sbci r25, 0xFF
	rjmp 1f

function sm_soft_from_u64
	clt
1:	ldi r31, hi8((1023 + 60) * 16)
	rjmp .Lwhole

; A 32-bit integer is processed as the upper half of 64 bits.
function sm_soft_from_i32
	bst r25, 7
	brtc 1f
	com r25
	com r24
	com r23
	neg r22
	sbci r23, 0xFF
	sbci r24, 0xFF
	sbci r25, 0xFF
	rjmp 1f

function sm_soft_from_u32
	clt
1:	clr r18
	clr r19
	clr r20
	clr r21
	ldi r31, hi8((1023 + 60 - 32) * 16)
; The exponent is for a leading bit at bit 4 of r25; the code moves it there.
.Lwhole:
	ldi r30, lo8((1023 + 60) * 16)
	clr r27
	tst r25
	brne 3f
	mov r26, r24
	or r26, r23
	or r26, r22
	or r26, r21
	or r26, r20
	or r26, r19
	or r26, r18
	breq 9f
2:	mov r25, r24
	mov r24, r23
	mov r23, r22
	mov r22, r21
	mov r21, r20
	mov r20, r19
	mov r19, r18
	clr r18
	subi r30, 0x80
	sbci r31, 0
	tst r25
	breq 2b
3:	cpi r25, 0x20
	brsh 6f
4:	sbrc r25, 4
	rjmp 8f
	subi r30, 0x10
	sbci r31, 0
	lsl r18
	rol r19
	rol r20
	rol r21
	rol r22
	rol r23
	rol r24
	rol r25
	rjmp 4b
6:	subi r30, 0xF0
	sbci r31, 0xFF
	lsr r25
	ror r24
	ror r23
	ror r22
	ror r21
	ror r20
	ror r19
	ror r18
	ror r27
	cpi r25, 0x20
	brsh 6b
8:	cpse r27, r1
	ori r18, 1
	mov r27, r18
	mov r18, r19
	mov r19, r20
	mov r20, r21
	mov r21, r22
	mov r22, r23
	mov r23, r24
	mov r24, r25
	rjmp finish16
9:	ret

function sm_soft_from_f32
	bst r25, 7
	mov r30, r25
	mov r26, r24
	lsl r26
	rol r30
	clr r31
	clr r27
	clr r21
	clr r20
	clr r19
	clr r18
	mov r26, r24
	andi r26, 0x7F
	or r26, r23
	or r26, r22                       ; 0: the fraction is zero
	cpi r30, 0xFF
	breq 4f
	ori r24, 0x80
	tst r30
	brne 2f
	tst r26
	breq 5f
	andi r24, 0x7F                    ; subnormal: it is a normal number in binary64
	adiw r30, 1
1:	sbiw r30, 1
	lsl r22
	rol r23
	rol r24
	brpl 1b
2:	subi r30, lo8(-896)
	sbci r31, hi8(-896)
	lsr r24
	ror r23
	ror r22
	ror r21
	lsr r24
	ror r23
	ror r22
	ror r21
	lsr r24
	ror r23
	ror r22
	ror r21
	rjmp .Lx16
4:	tst r26
	brne 6f
	rjmp .Linfinity
5:	rjmp .Lzero
6:	rjmp .Lnot_a_number

; ---- to integers ----

	.section .text.sm_soft_to, "ax", @progbits

; Sets r31:r30 to the exponent of a without its bias, and T to the sign.  Sets carry if |a| is below 1.
.Lpower:
	bst r25, 7
	mov r30, r24
	mov r31, r25
	andi r31, 0x7F
	swap r30
	andi r30, 0x0F
	swap r31
	mov r26, r31
	andi r26, 0xF0
	or r30, r26
	andi r31, 0x0F
	subi r30, lo8(1023)
	sbci r31, hi8(1023)
	ret

; Shifts the significand, with its leading bit at bit 60 of 64, right by r26, or left if that is negative.
.Lmove:
	andi r24, 0x0F
	ori r24, 0x10
	mov r25, r24
	mov r24, r23
	mov r23, r22
	mov r22, r21
	mov r21, r20
	mov r20, r19
	mov r19, r18
	clr r18
	tst r26
	brmi 4f
1:	subi r26, 8
	brcs 2f
	mov r18, r19
	mov r19, r20
	mov r20, r21
	mov r21, r22
	mov r22, r23
	mov r23, r24
	mov r24, r25
	clr r25
	rjmp 1b
2:	subi r26, 0xF8
	breq 5f
3:	lsr r25
	ror r24
	ror r23
	ror r22
	ror r21
	ror r20
	ror r19
	ror r18
	dec r26
	brne 3b
	ret
4:	lsl r18
	rol r19
	rol r20
	rol r21
	rol r22
	rol r23
	rol r24
	rol r25
	inc r26
	brne 4b
5:	ret

; Sets the result for an overflow, all bits 1, or for NaN, 0 with T clear.
.Ltoo_large:
	cpi r31, 4
	brne 1f
	andi r24, 0x0F
	or r24, r23
	or r24, r22
	or r24, r21
	or r24, r20
	or r24, r19
	or r24, r18
	breq 1f
.Lnothing:
	clt
	clr r18
	rjmp .Lall
1:	ldi r18, 0xFF
.Lall:
	mov r19, r18
	mov r20, r18
	mov r21, r18
	mov r22, r18
	mov r23, r18
	mov r24, r18
	mov r25, r18
	ret

function sm_soft_to_u32
	rcall .Lpower
	brcs .Lnothing
	brts .Lnothing
	cpi r30, 32
	cpc r31, r1
	brsh .Ltoo_large
	ldi r26, 60 - 32
	sub r26, r30
	rjmp .Lmove

function sm_soft_to_u64
	rcall .Lpower
	brcs .Lnothing
	brts .Lnothing
	cpi r30, 64
	cpc r31, r1
	brsh .Ltoo_large
	ldi r26, 60
	sub r26, r30
	rjmp .Lmove

function sm_soft_to_i32
	rcall .Lpower
	brcs .Lnothing
	cpi r30, 31
	cpc r31, r1
	brsh .Lto_end
	ldi r26, 60 - 32
	sub r26, r30
	rcall .Lmove
	brtc 1f
	com r25
	com r24
	com r23
	neg r22
	sbci r23, 0xFF
	sbci r24, 0xFF
	sbci r25, 0xFF
1:	ret

function sm_soft_to_i64
	rcall .Lpower
	brcs .Lnothing
	cpi r30, 63
	cpc r31, r1
	brsh .Lto_end
	ldi r26, 60
	sub r26, r30
	rcall .Lmove
	brtc 1f
	com r25
	com r24
	com r23
	com r22
	com r21
	com r20
	com r19
	neg r18
	sbci r19, 0xFF
	sbci r20, 0xFF
	sbci r21, 0xFF
	sbci r22, 0xFF
	sbci r23, 0xFF
	sbci r24, 0xFF
	sbci r25, 0xFF
1:	ret

.Lto_end:
	rcall .Ltoo_large
	brts 1f
	andi r25, 0x7F
	ret
1:	clr r18
	rcall .Lall
	ldi r25, 0x80
	ret

function sm_soft_to_f32
	rcall .Lpower
	andi r24, 0x0F
	ldi r26, 4                        ; 1024: infinity or NaN
	cp r30, r1
	cpc r31, r26
	brne 4f
	rjmp 8f
4:	ori r24, 0x10                     ; subnormals become 0 with or without this bit
	ldi r25, 3
1:	lsl r20
	rol r21
	rol r22
	rol r23
	rol r24
	dec r25
	brne 1b
	or r20, r19
	or r20, r18
	cpse r20, r1
	ori r21, 1
	subi r30, lo8(896 - 1023)
	sbci r31, hi8(896 - 1023)
	cp r1, r30
	cpc r1, r31
	brlt 2f
	subi r30, 1                       ; the result is subnormal
	sbci r31, 0
	cpi r30, 0xE7                     ; -25
	ldi r26, 0xFF
	cpc r31, r26
	brlt 6f
1:	lsr r24
	ror r23
	ror r22
	ror r21
	brcc 3f
	ori r21, 1
3:	inc r30
	brne 1b
	ldi r30, 1
	clr r31
2:	cpi r30, 0xFF
	cpc r31, r1
	brge 7f
	mov r25, r30
	dec r25
	clr r26
	lsr r25
	ror r26
	add r24, r26
	adc r25, r1
	cpi r21, 0x80
	brlo 5f
	brne 4f
	sbrs r22, 0
	rjmp 5f
4:	sec
	adc r22, r1
	adc r23, r1
	adc r24, r1
	adc r25, r1
5:	bld r25, 7
	ret
6:	clr r25
	clr r24
	rjmp 9f
8:	or r24, r23
	or r24, r22
	or r24, r21
	or r24, r20
	or r24, r19
	or r24, r18
	ldi r24, 0xC0
	brne 1f
7:	ldi r24, 0x80
1:	ldi r25, 0x7F
9:	clr r23
	clr r22
	rjmp 5b

#endif
