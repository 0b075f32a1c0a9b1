// SPDX-License-Identifier: Apache-2.0
// Operations on 64-bit values in memory, for AVR (soft_cells.h).  The calling convention of avr-gcc: the first pointer is in r25:r24, the
// second in r23:r22.  A 32-bit argument after one pointer is in r23:r20, after two in r21:r18.  The result is in r24.
#include "stdlib/soft_pack.h"

#ifdef SM_SOFT_ASSEMBLY
	.section .text.sm_soft_cells, "ax", @progbits

; Loads the upper half of x to r25:r24:r19:r18 and n to r23:r20, both without the sign of n.  N is set if x has the other sign.
; Z points to x.
take_sides:
	movw r30, r24
	ldd r18, Z+4
	ldd r19, Z+5
	ldd r24, Z+6
	ldd r25, Z+7
	bst r23, 7
	andi r23, 0x7F
	brtc 1f
	subi r25, 0x80
1:	tst r25
	ret

	.global sm_soft_beyond
	.type sm_soft_beyond, @function
sm_soft_beyond:
	rcall take_sides
	brmi .Lcell_no
	cp r20, r18
	cpc r21, r19
	cpc r22, r24
	cpc r23, r25
	brlo .Lcell_no_nan
	brne .Lcell_no
	ld r24, Z
	ldd r25, Z+1
	or r24, r25
	ldd r25, Z+2
	or r24, r25
	ldd r25, Z+3
	or r24, r25
	brne .Lcell_yes
.Lcell_no:
	ldi r24, 0
	ret

	.global sm_soft_reaches
	.type sm_soft_reaches, @function
sm_soft_reaches:
	rcall take_sides
	brmi .Lcell_no
	cp r18, r20
	cpc r19, r21
	cpc r24, r22
	cpc r25, r23
	brlo .Lcell_no
.Lcell_no_nan:
	cpi r24, 0xF0
	ldi r26, 0x7F
	cpc r25, r26
	brsh .Lcell_infinite
.Lcell_yes:
	ldi r24, 1
	ret
.Lcell_infinite:
	subi r24, 0xF0
	or r24, r19
	or r24, r18
	ldd r18, Z+3
	or r24, r18
	ldd r18, Z+2
	or r24, r18
	ldd r18, Z+1
	or r24, r18
	ld r18, Z
	or r24, r18
	breq .Lcell_yes
	rjmp .Lcell_no

	.section .text.sm_soft_exceeds, "ax", @progbits
	.global sm_soft_exceeds
	.type sm_soft_exceeds, @function
sm_soft_exceeds:
	movw r30, r24
	ld r24, Z
	cp r20, r24
	ldd r24, Z+1
	cpc r21, r24
	ldd r24, Z+2
	cpc r22, r24
	ldd r24, Z+3
	cpc r23, r24
	sbc r25, r25                      ; nonzero if n is below the lower half
	ldd r24, Z+4
	or r25, r24
	ldd r24, Z+5
	or r25, r24
	ldd r24, Z+6
	or r25, r24
	ldd r24, Z+7
	or r25, r24
	ldi r24, 0
	breq 1f
	ldi r24, 1
1:	ret

	.section .text.sm_soft_elapsed_exceeds, "ax", @progbits
	.global sm_soft_elapsed_exceeds
	.type sm_soft_elapsed_exceeds, @function
sm_soft_elapsed_exceeds:
	movw r30, r24                     ; start
	movw r26, r22                     ; time
	ld r22, X+
	ld r0, Z
	sub r22, r0
	ld r23, X+
	ldd r0, Z+1
	sbc r23, r0
	ld r24, X+
	ldd r0, Z+2
	sbc r24, r0
	ld r25, X+
	ldd r0, Z+3
	sbc r25, r0
	sbc r0, r0                        ; saves the borrow
	cp r18, r22
	cpc r19, r23
	cpc r20, r24
	cpc r21, r25
	sbc r18, r18                      ; nonzero if n is below the lower half
	lsl r0
	ld r22, X+
	ldd r0, Z+4
	sbc r22, r0
	or r18, r22
	ld r23, X+
	ldd r0, Z+5
	sbc r23, r0
	or r18, r23
	ld r24, X+
	ldd r0, Z+6
	sbc r24, r0
	or r18, r24
	ld r25, X
	ldd r0, Z+7
	sbc r25, r0
	ldi r24, 0
	or r18, r25
	breq 1f
	ldi r24, 1
1:	ret

	.section .text.sm_soft_increment, "ax", @progbits
	.global sm_soft_increment
	.type sm_soft_increment, @function
sm_soft_increment:
	movw r30, r24
	ld r24, Z
	cpi r24, 0
	breq .Lcount_end
.Lcount_up:
	inc r24
	st Z+, r24
	breq 1f
	ret
1:	ld r24, Z                         ; carry; it never leaves the eighth byte, because the value is below 2^53
	inc r24
	st Z+, r24
	breq 1b
	ret
.Lcount_end:                                 ; 2^53 has a zero low byte
	ldd r25, Z+6
	sbrs r25, 5
	rjmp .Lcount_up
	ret

	.section .text.sm_soft_advance, "ax", @progbits
	.global sm_soft_advance
	.type sm_soft_advance, @function
sm_soft_advance:
	movw r30, r24                     ; gate
	movw r26, r22                     ; time
	ld r18, X+
	ld r19, X+
	ld r20, X+
	ld r21, X+
	ld r22, X+
	ld r23, X+
	ld r24, X+
	ld r25, X
	subi r18, 0xFF                    ; + 1
	sbci r19, 0xFF
	sbci r20, 0xFF
	sbci r21, 0xFF
	sbci r22, 0xFF
	sbci r23, 0xFF
	sbci r24, 0xFF
	sbci r25, 0xFF
	ld r0, Z
	cp r0, r18
	ldd r0, Z+1
	cpc r0, r19
	ldd r0, Z+2
	cpc r0, r20
	ldd r0, Z+3
	cpc r0, r21
	ldd r0, Z+4
	cpc r0, r22
	ldd r0, Z+5
	cpc r0, r23
	ldd r0, Z+6
	cpc r0, r24
	ldd r0, Z+7
	cpc r0, r25
	brsh 1f
	st Z, r18
	std Z+1, r19
	std Z+2, r20
	std Z+3, r21
	std Z+4, r22
	std Z+5, r23
	std Z+6, r24
	std Z+7, r25
	ldi r24, 1
	ret
1:	ldi r24, 0
	ret

	.section .text.sm_soft_sum_f32, "ax", @progbits

; Shifts the digits r26:r24, and r0 below them, right by r27.
.macro digits_down
	tst r27
	breq 2f
1:	lsr r26
	ror r25
	ror r24
	ror r0
	dec r27
	brne 1b
2:
.endm

; The sum is r23:r18.  The leading digit of a sample with the largest exponent, which is in r17, is at bit 7 of r22.
	.global sm_soft_sum_f32
	.type sm_soft_sum_f32, @function
sm_soft_sum_f32:
	push r16
	push r17
	movw r30, r24
	mov r16, r22
	ldi r17, 1
1:	ldd r24, Z+2                      ; finds the largest exponent
	ldd r25, Z+3
	sbrs r25, 7
	rjmp 2f
	com r24
	com r25
2:	lsl r24
	rol r25
	cp r17, r25
	brsh 3f
	mov r17, r25
3:	adiw r30, 4
	dec r22
	brne 1b
	clr r18
	clr r19
	movw r20, r18
	movw r22, r18
	cpi r17, 0xFF
	brne .Lsum_next
	rjmp .Lsum_none                   ; an infinity
.Lsum_next:                               ; adds the samples, the last one first
	sbiw r30, 4
	ld r24, Z
	ldd r25, Z+1
	ldd r26, Z+2
	ldd r27, Z+3
	bst r27, 7
	brtc 1f
	com r24
	com r25
	com r26
	com r27
1:	clr r0
	lsl r26
	rol r27                           ; its exponent
	brne 2f
	inc r27                           ; subnormal, or 0: no leading digit is added
	lsr r26
	rjmp 3f
2:	sec
	ror r26
3:	sub r27, r17
	neg r27
	cpi r27, 8
	brsh .Lsum_low
	digits_down
	brts 4f
	add r19, r0
	adc r20, r24
	adc r21, r25
	adc r22, r26
	adc r23, r1
	dec r16
	brne .Lsum_next
	rjmp .Lsum_ready
4:	sub r19, r0
	sbc r20, r24
	sbc r21, r25
	sbc r22, r26
	sbc r23, r1
.Lsum_added:
	dec r16
	brne .Lsum_next
.Lsum_ready:
	clr r24
	sbrc r23, 7
	com r24
	mov r25, r24
#ifdef __AVR_HAVE_JMP_CALL__
	call sm_soft_from_i64
#else
	rcall sm_soft_from_i64
#endif
	tst r25
	breq .Lsum_end                    ; the sum is 0
	ldi r26, 16
	mul r17, r26
	add r24, r0
	adc r25, r1
	clr r1
	subi r24, lo8((150 + 16) * 16)
	sbci r25, hi8((150 + 16) * 16)
.Lsum_end:
	pop r17
	pop r16
	ret
.Lsum_low:
	subi r27, 8
	cpi r27, 8
	brsh .Lsum_far
	digits_down
	brts 5f
	add r18, r0
	adc r19, r24
	adc r20, r25
	adc r21, r26
	adc r22, r1
	adc r23, r1
	rjmp .Lsum_added
5:	sub r18, r0
	sbc r19, r24
	sbc r20, r25
	sbc r21, r26
	sbc r22, r1
	sbc r23, r1
	rjmp .Lsum_added
.Lsum_far:
	or r24, r25
	or r24, r26
	breq .Lsum_added                  ; it is 0
.Lsum_none:
	clr r18
	clr r19
	movw r20, r18
	movw r22, r18
	movw r24, r18
	rjmp .Lsum_end
#endif
