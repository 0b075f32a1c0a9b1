// SPDX-License-Identifier: Apache-2.0
// The digits of a square root for AVR with a multiplier, about nine times as fast as the code of math.h compiled by avr-gcc, and shorter.
// The calling convention is that of soft_avr.S.
#include "stdlib/soft_pack.h"

#ifdef SM_SOFT_ASSEMBLY

	.section .text.sm_soft_sqrt_digits, "ax", @progbits

; sm_sqrt_digits of math.h, one bit at a time.  r24:r18 is what is left, r16:r10 twice the root, r8:r2 the current bit.
	.global sm_soft_sqrt_digits
	.type sm_soft_sqrt_digits, @function
sm_soft_sqrt_digits:
	.irp r, 2, 3, 4, 5, 6, 7, 8, 10, 11, 12, 13, 14, 15, 16
	push r\r
	.endr
	lsl r18                           ; a is a multiple of 2^8: a >> 7 is a << 1, one byte further down
	rol r19
	rol r20
	rol r21
	rol r22
	rol r23
	rol r24
	rol r25
	mov r18, r19
	mov r19, r20
	mov r20, r21
	mov r21, r22
	mov r22, r23
	mov r23, r24
	mov r24, r25
	clr r10
	clr r11
	movw r12, r10
	movw r14, r10
	clr r16
	movw r2, r10
	movw r4, r10
	movw r6, r10
	ldi r25, 0x20
	mov r8, r25
1:	or r10, r2
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
	brlo 2f
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
	rjmp 3f
2:	eor r10, r2
	eor r11, r3
	eor r12, r4
	eor r13, r5
	eor r14, r6
	eor r15, r7
	eor r16, r8
3:	lsl r18
	rol r19
	rol r20
	rol r21
	rol r22
	rol r23
	rol r24
	lsr r8
	ror r7
	ror r6
	ror r5
	ror r4
	ror r3
	ror r2
	brcc 1b
	ldi r25, 2                        ; rounds: the root has one bit more than fits, and a tie is impossible
	add r10, r25
	adc r11, r1
	adc r12, r1
	adc r13, r1
	adc r14, r1
	adc r15, r1
	adc r16, r1
4:	lsr r16
	ror r15
	ror r14
	ror r13
	ror r12
	ror r11
	ror r10
	dec r25
	brne 4b
	movw r18, r10
	movw r20, r12
	movw r22, r14
	mov r24, r16
	.irp r, 16, 15, 14, 13, 12, 11, 10, 8, 7, 6, 5, 4, 3, 2
	pop r\r
	.endr
	ret

#endif
