// SPDX-License-Identifier: Apache-2.0
// A function of an image on AVR, images in flash: what run of interp.c does, to the same bits.  What is rare it leaves to the functions
// of interp.c that do it there: smvm_do_….  interp_avr_eeprom.S is the same for images in flash or EEPROM.
//
// Takes Run in r25:r24 and the number of the function in r23:r22; gives the state that it goes to, or 0, in r25:r24.  Between instructions:
//   r9:r2    X: a number of 64 bits, or a whole one in r5:r2        r17  1: it is the former
//   r15:r14  the locals        r13:r12  the state vector        Y  Run        Z  the next byte of the image
// and in one
//   r22      the opcode        r21:r18  the number behind it
// Calls leave r2 to r17 as they were, and r11:r10 keeps Z over them.
#if defined(__AVR_HAVE_MUL__) && !defined(SMVM_PORTABLE)
#include "bytecode-vm/interp_avr.h"

; The next byte of the image.
#ifdef SMVM_EEPROM
#define RUN smvm_run_eeprom
#define BEGIN smvm_begin_eeprom
#include <avr/io.h>
.macro fetch to
	sbrc r31, 7
	rjmp .Leeprom\@
	lpm \to, Z+
.Lgot\@:
	.subsection 1
.Leeprom\@:
	rcall read_eeprom
	mov \to, r0
	rjmp .Lgot\@
	.previous
.endm
.macro fetch_apart to                     ; where it is seldom
	rcall read
	mov \to, r0
.endm
#else
#define RUN smvm_run_flash
#define BEGIN smvm_begin_flash
.macro fetch to
	lpm \to, Z+
.endm
.macro fetch_apart to
	fetch \to
.endm
#endif

.macro xcall name
#ifdef __AVR_HAVE_JMP_CALL__
	call \name
#else
	rcall \name
#endif
.endm

; A varint to r21:r18.
.macro number
	fetch r18
	clr r19
	clr r20
	clr r21
	cpi r18, 0x60
	brlo 9f
	rcall long_number
9:
.endm

	.section .text.RUN, "ax", @progbits

; The others of a varint of two or four bytes, of whose first r18 is.
long_number:
	cpi r18, 0x78
	brsh 1f
	subi r18, 0x60
	mov r19, r18
	clr r18
	lsr r19
	ror r18
	fetch_apart r0
	or r18, r0
	subi r18, 0xA0                    ; + 0x60
	sbci r19, 0xFF
	ret
1:	andi r18, 7
	ldi r23, 3
2:	mov r21, r20
	mov r20, r19
	mov r19, r18
	clr r18
	lsr r21
	ror r20
	ror r19
	ror r18
	fetch_apart r0
	or r18, r0
	dec r23
	brne 2b
	subi r18, 0xA0                    ; + 0xC60
	sbci r19, 0xF3
	sbci r20, 0xFF
	sbci r21, 0xFF
	ret

; An entry of the table of functions to r21:r20; it has r18 bytes.
entry:
	fetch_apart r20
	clr r21
	mov r19, r18
	dec r19
	breq 1f
	fetch_apart r21
	dec r19
	breq 1f
	fetch_apart r0
1:	ret

; bool BEGIN(SmVm *vm, const void *g): what smvm_begin does with G, and what the step before stored is cleared.
	.global BEGIN
	.type BEGIN, @function
BEGIN:
	movw r30, r24
	movw r26, r22
	adiw r30, VM_NEXT
	ldi r19, 0xFF
	ldi r20, 8
	clr r24
	clc
1:	ld r18, X+
	ld r0, Z+
	cpc r18, r0
	and r19, r18
	dec r20
	brne 1b
	brlo 2f                           ; G + 1 is not above
	cpi r19, 0xFF
	breq 2f                           ; the last G there is
	movw r26, r22
	sbiw r30, 8
	ldi r20, 8
	sec
1:	ld r18, X+
	adc r18, r1
	st Z+, r18
	std Z+VM_STORED-VM_NEXT-1, r1
	dec r20
	brne 1b
	ldi r24, 1
2:	ret

	.global RUN
	.type RUN, @function
RUN:
	movw r26, r24
	movw r30, r24
	ldd r18, Z+RUN_WIDTH
	ldd r20, Z+RUN_FUNCTIONS
	ldd r21, Z+RUN_FUNCTIONS+1
	movw r30, r20
	clr r24
	clr r25
	subi r22, 1
	sbci r23, 0
	brcs 2f                           ; the first function begins at 0
	mov r19, r18
1:	add r30, r22
	adc r31, r23
	dec r19
	brne 1b
	rcall entry
	movw r24, r20
2:	rcall entry
	cp r20, r24
	cpc r21, r25
	brne 3f
	clr r24
	clr r25
	ret
3:	.irp r, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 28, 29
	push r\r
	.endr
	movw r28, r26
	ldd r30, Y+RUN_CODE
	ldd r31, Y+RUN_CODE+1
	add r30, r24
	adc r31, r25
bases:
	ldd r12, Y+RUN_SV
	ldd r13, Y+RUN_SV+1
	ldd r14, Y+RUN_LOCALS
	ldd r15, Y+RUN_LOCALS+1

; ---- the next instruction ----

next:
	fetch r22
	fetch r18                         ; behind `end`, which is last, this may be anything
	clr r19
	clr r20
	clr r21
	cpi r18, 0x60
	brsh 3f
1:	cpi r22, 0xC0
	brlo loads
	cpi r22, 0xD0
	brsh 2f
	rjmp puts
2:	rjmp jumps
3:	cpi r18, 0x80
	brsh 4f
	rcall long_number
	rjmp 1b
4:	sbiw r30, 1                       ; the next opcode: this one has no number
	cpi r22, 0xCE
	breq end
	brlo 5f
	rjmp compute
5:	rjmp time

end:
	clr r18
	clr r19
leave:                                    ; with r19:r18
	.irp r, 29, 28, 17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2
	pop r\r
	.endr
	movw r24, r18
	ret

; ---- loads ----

loads:
	mov r23, r22
	andi r23, 0x0F                    ; the type
	cpi r23, 12
	brsh to_others
	movw r24, r14
	sbrc r22, 4
	movw r24, r12
	movw r26, r18
	sbrc r23, 3
	rjmp wide
	sbrc r23, 1
	rjmp words
	sbrc r23, 0
	rjmp half
byte:
	add r26, r24
	adc r27, r25
	ld r18, X
	clr r19
	sbrs r18, 7
	rjmp 1f
	sbrs r23, 2
	com r19
1:	mov r20, r19
	mov r21, r19
	rjmp whole
half:
	lsl r26
	rol r27
	add r26, r24
	adc r27, r25
	ld r18, X+
	ld r19, X
	clr r20
	sbrs r19, 7
	rjmp 1f
	sbrs r23, 2
	com r20
1:	mov r21, r20
whole:                                    ; r21:r18 to X, or Y
	sbrc r22, 5
	rjmp 1f
	movw r2, r18
	movw r4, r20
	clr r17
	rjmp next
1:	std Y+RUN_Y, r18
	std Y+RUN_Y+1, r19
	std Y+RUN_Y+2, r20
	std Y+RUN_Y+3, r21
	std Y+RUN_Y+8, r1
	rjmp next
to_others:
	rjmp others

words:                                    ; four bytes or eight
	sbrc r23, 0
	rjmp 2f
	rcall place4
	cpi r23, 6
	brne 1f
	adiw r26, 3
	ld r0, X
	sbrc r0, 7
	rjmp load                         ; not below 2^31
	sbiw r26, 3
1:	ld r18, X+
	ld r19, X+
	ld r20, X+
	ld r21, X
	rjmp whole
2:	rcall place8
	adiw r26, 3
	ld r24, X+
	andi r24, 0x80
	ld r0, X+
	or r24, r0
	ld r0, X+
	or r24, r0
	ld r0, X+
	or r24, r0
	ld r0, X
	or r24, r0
	brne 3f
	sbiw r26, 7
	rjmp 1b
3:	rjmp load

place8:                                   ; X is an offset in units of 8 bytes, behind r25:r24: the address
	lsl r26
	rol r27
place4:
	lsl r26
	rol r27
	lsl r26
	rol r27
	add r26, r24
	adc r27, r25
	ret

wide:                                     ; F32, F64, bool, RAW
	sbrs r23, 0
	rjmp 3f
	rcall place8
	ld r18, X+
	ld r19, X+
	ld r20, X+
	ld r21, X+
	ld r0, X+
	ld r23, X+
	ld r24, X+
	ld r25, X
	mov r26, r25
	ori r26, 0x80
	cpi r26, 0xFF
	breq 4f
1:	sbrc r22, 5
	rjmp 2f
	movw r2, r18
	movw r4, r20
	mov r6, r0
	mov r7, r23
	movw r8, r24
	ldi r17, 1
	rjmp next
2:	std Y+RUN_Y, r18
	std Y+RUN_Y+1, r19
	std Y+RUN_Y+2, r20
	std Y+RUN_Y+3, r21
	std Y+RUN_Y+4, r0
	std Y+RUN_Y+5, r23
	std Y+RUN_Y+6, r24
	std Y+RUN_Y+7, r25
	ldi r18, 1
	std Y+RUN_Y+8, r18
	rjmp next
3:	cpi r23, 10
	brne load                         ; an F32
	add r26, r24
	adc r27, r25
	ld r18, X
	cpse r18, r1
	ldi r18, 1
	clr r19
	clr r20
	clr r21
	rjmp whole
4:	mov r26, r22                      ; perhaps infinite or NaN
	andi r26, 0x0F
	cpi r26, 11
	breq 1b                           ; kept as it is
	cpi r24, 0xF0
	brlo 1b
	mov r26, r24
	andi r26, 0x0F
	or r26, r23
	or r26, r0
	or r26, r21
	or r26, r20
	or r26, r19
	or r26, r18
	breq 1b
	clr r18
	clr r19
	clr r20
	clr r21
	rjmp whole

load:
	rcall spill
	xcall smvm_do_load
	rjmp filled

others:
	cpi r22, 0xBD
	breq put_x
	cpi r22, 0xBE
	breq to_set
	cpi r23, 14
	brsh 1f
	sbrc r22, 4
	rjmp stat
	sbrs r23, 0
	rjmp whole                        ; n
	com r18                           ; -1 - n
	com r19
	com r20
	com r21
	rjmp whole
to_set:
	rjmp set
1:	sbrs r22, 4
	rjmp load                         ; an F32 or F64 constant
	tst r17
	brne load
	rcall two                         ; + n, - n
	brvs load
taken:
	movw r2, r24
	movw r4, r26
	rjmp next

put_x:                                    ; what gives X a number
	rcall spill
	xcall smvm_do_put
	rjmp filled

stat:
	mov r16, r18
	number
	movw r20, r18
	mov r22, r16
	rcall spill
	xcall smvm_do_stat
	rjmp filled

set:
	mov r16, r18
	rcall relate
	and r24, r16
	ldi r18, 1
	brne 1f
	clr r18
1:	clr r19
	movw r2, r18
	clr r4
	clr r5
	clr r17
	rjmp next

; X to memory, for a function that takes Run.
spill:
	movw r10, r30
	movw r24, r28
	std Y+RUN_X, r2
	std Y+RUN_X+1, r3
	std Y+RUN_X+2, r4
	std Y+RUN_X+3, r5
	std Y+RUN_X+4, r6
	std Y+RUN_X+5, r7
	std Y+RUN_X+6, r8
	std Y+RUN_X+7, r9
	std Y+RUN_X+8, r17
	ret

filled:
	ldd r2, Y+RUN_X
	ldd r3, Y+RUN_X+1
	ldd r4, Y+RUN_X+2
	ldd r5, Y+RUN_X+3
	ldd r6, Y+RUN_X+4
	ldd r7, Y+RUN_X+5
	ldd r8, Y+RUN_X+6
	ldd r9, Y+RUN_X+7
	ldd r17, Y+RUN_X+8
back:
	movw r30, r10
	rjmp next

time:                                     ; X or Y = T
	movw r26, r28
	ldd r0, Y+RUN_VM
	ldd r29, Y+RUN_VM+1
	mov r28, r0
	clr r24
	ldd r18, Y+VM_NEXT
	ldd r0, Y+VM_START
	sub r18, r0
	ldd r19, Y+VM_NEXT+1
	ldd r0, Y+VM_START+1
	sbc r19, r0
	ldd r20, Y+VM_NEXT+2
	ldd r0, Y+VM_START+2
	sbc r20, r0
	ldd r21, Y+VM_NEXT+3
	ldd r0, Y+VM_START+3
	sbc r21, r0
	.irp i, 4, 5, 6, 7
	ldd r23, Y+VM_NEXT+\i
	ldd r0, Y+VM_START+\i
	sbc r23, r0
	or r24, r23
	.endr
	movw r28, r26
	sbrc r21, 7
	rjmp 1f
	tst r24
	brne 1f
	rjmp whole
1:	rcall spill
	xcall smvm_do_time
	rjmp filled

; ---- stores ----

puts:                                     ; 0xC0 to 0xCF
	mov r23, r22
	andi r23, 0x0F
	movw r24, r14
	movw r26, r18
	cpi r23, 12
	brlo store
	breq out
	cpi r23, 14
	brsh 1f
	rjmp leave                        ; goto
1:	brne put
	rjmp end

put:
	rcall spill
	xcall smvm_do_put
	rjmp back

out:
	cpi r18, 64
	cpc r19, r1
	brsh put
	ldi r24, 1                        ; its bit, of those that say what is written
	sbrc r18, 1
	ldi r24, 4
	sbrc r18, 0
	lsl r24
	sbrc r18, 2
	swap r24
	mov r25, r18
	lsr r25
	lsr r25
	lsr r25
	ldd r26, Y+RUN_VM
	ldd r27, Y+RUN_VM+1
	adiw r26, VM_STORED
	add r26, r25
	adc r27, r1
	ld r0, X
	or r0, r24
	st X, r0
	movw r10, r30                     ; its place
	ldd r30, Y+RUN_OUTPUTS
	ldd r31, Y+RUN_OUTPUTS+1
	movw r24, r18
	add r24, r18
	adc r25, r19
	add r24, r18
	adc r25, r19
	add r30, r24
	adc r31, r25
	fetch_apart r26
	fetch_apart r27
	fetch_apart r23
	andi r23, 0x0F
	movw r24, r12
	movw r30, r10
; X to what is X units of type r23 behind r25:r24.
store:
	sbrc r23, 3
	rjmp store_wide
	sbrc r17, 0
	rjmp put
	sbrc r23, 1
	rjmp store_words
	clr r0
	sbrc r23, 0
	rjmp 2f
	sbrs r23, 2                       ; one byte, if the others are its sign
	sbrs r2, 7
	rjmp 1f
	com r0
1:	cp r3, r0
	cpc r4, r0
	cpc r5, r0
	brne to_put
	add r26, r24
	adc r27, r25
	st X, r2
	rjmp next
2:	sbrs r23, 2                       ; two bytes
	sbrs r3, 7
	rjmp 3f
	com r0
3:	cp r4, r0
	cpc r5, r0
	brne to_put
	lsl r26
	rol r27
	add r26, r24
	adc r27, r25
	st X+, r2
	st X, r3
	rjmp next
to_put:
	rjmp put
store_words:
	clr r0
	sbrs r5, 7
	rjmp 1f
	sbrc r23, 2
	rjmp put                          ; below 0
	com r0
1:	sbrc r23, 0
	rjmp 2f
	rcall place4
	st X+, r2
	st X+, r3
	st X+, r4
	st X, r5
	rjmp next
2:	rcall place8
	st X+, r2
	st X+, r3
	st X+, r4
	st X+, r5
	st X+, r0
	st X+, r0
	st X+, r0
	st X, r0
	rjmp next
store_wide:
	cpi r23, 10
	breq 3f
	sbrc r23, 0
	sbrs r17, 0
1:	rjmp put                          ; an F32; a whole number to an F64
	cpi r23, 11
	breq 2f
	mov r0, r9
	lsl r0
	mov r23, r0
	cpi r23, 0xFE
	breq 1b                           ; perhaps NaN
2:	rcall place8
	st X+, r2
	st X+, r3
	st X+, r4
	st X+, r5
	st X+, r6
	st X+, r7
	st X+, r8
	st X, r9
	rjmp next
3:	tst r17                           ; bool
	brne 1b
	add r26, r24
	adc r27, r25
	mov r0, r2
	or r0, r3
	or r0, r4
	or r0, r5
	ldi r23, 1
	cpse r0, r1
	rjmp 4f
	clr r23
4:	st X, r23
	rjmp next

; ---- jumps ----

jumps:                                    ; 0xD0 to 0xEF
	cpi r22, 0xE0
	brsh 1f
	cpi r22, 0xDF
	breq jump
	push r18                          ; jxy
	push r19
	push r22
	rcall relate
	pop r22
	pop r19
	pop r18
	and r24, r22
	brne jump
	rjmp next
jump:
	add r30, r18
	adc r31, r19
	rjmp next
1:	breq 2f
	cpi r22, 0xEF
	brne with
2:	tst r17                           ; jf, jt
	brne 4f
	mov r24, r2
	or r24, r3
	or r24, r4
	or r24, r5
3:	ldi r25, 0                        ; jf jumps at 0
	cpse r24, r1
	ldi r25, 1
	eor r25, r22
	sbrs r25, 0
	rjmp jump
	rjmp next
4:	push r18
	push r19
	push r22
	movw r10, r30
	rcall x_to_a
	xcall sm_soft_truth
	movw r30, r10
	pop r22
	pop r19
	pop r18
	rjmp 3b

with:                                     ; jxn
	tst r17
	brne with_real
	rcall compare
	and r24, r22
read_jump:
	number
	tst r24
	brne jump
	rjmp next

; The relation of X to n, a number of 64 bits each.
with_real:
	push r30
	push r31
	push r22
	mov r24, r20
	or r24, r21
	breq 2f
	movw r22, r18
	movw r24, r20
	xcall sm_soft_from_i32
	movw r10, r18
	movw r12, r20
	movw r14, r22
	movw r16, r24
1:	rcall x_to_a
	xcall sm_soft_relation
	pop r22
	pop r31
	pop r30
	and r24, r22
	ldi r17, 1
	ldd r12, Y+RUN_SV
	ldd r13, Y+RUN_SV+1
	ldd r14, Y+RUN_LOCALS
	ldd r15, Y+RUN_LOCALS+1
	rjmp read_jump
2:	movw r10, r20                     ; 16 bits: the first digit moves to bit 4 of r16, r27:r26 is the exponent in X16 form, less 1
	movw r12, r20
	clr r14
	mov r15, r18
	mov r16, r19
	clr r17
	ldi r26, lo8((1023 + 12 - 1) * 16)
	ldi r27, hi8((1023 + 12 - 1) * 16)
	cpi r16, 0x20
	brsh 4f
	tst r16
	brne 3f
	mov r16, r15
	clr r15
	subi r26, 0x80
	sbci r27, 0
	cpi r16, 0x20
	brsh 4f
	tst r16
	breq 1b                           ; 0
3:	sbrc r16, 4
	rjmp 5f
	lsl r15
	rol r16
	subi r26, 0x10
	sbci r27, 0
	rjmp 3b
4:	lsr r16
	ror r15
	ror r14
	subi r26, 0xF0
	sbci r27, 0xFF
	cpi r16, 0x20
	brsh 4b
5:	mov r17, r27
	add r16, r26
	adc r17, r1
	rjmp 1b

x_to_a:
	movw r18, r2
	movw r20, r4
	movw r22, r6
	movw r24, r8
	ret

; The relation of X to Y to r24.
relate:
	ldd r24, Y+RUN_Y+8
	or r24, r17
	brne 2f
	ldd r18, Y+RUN_Y
	ldd r19, Y+RUN_Y+1
	ldd r20, Y+RUN_Y+2
	ldd r21, Y+RUN_Y+3
compare:                                  ; whole ones: of X to r21:r18
	cp r2, r18
	cpc r3, r19
	cpc r4, r20
	cpc r5, r21
	ldi r24, 2
	breq 1f
	ldi r24, 1
	brlt 1f
	ldi r24, 4
1:	ret
2:	rcall spill
	xcall smvm_do_relation
	movw r30, r10
	ret

; ---- of X, or of X and Y ----

compute:
	cpi r22, 0xF2
	brsh 2f
	ldd r24, Y+RUN_Y+8
	or r24, r17
	brne 2f
	ldd r18, Y+RUN_Y
	ldd r19, Y+RUN_Y+1
	ldd r20, Y+RUN_Y+2
	ldd r21, Y+RUN_Y+3
	rcall two
	brvs 2f
	rjmp taken
2:	rcall spill
	xcall smvm_do_compute
	rjmp filled

; X + r21:r18 to r27:r24, or minus where the opcode is odd.
two:
	movw r24, r2
	movw r26, r4
	sbrc r22, 0
	rjmp 1f
	add r24, r18
	adc r25, r19
	adc r26, r20
	adc r27, r21
	ret
1:	sub r24, r18
	sbc r25, r19
	sbc r26, r20
	sbc r27, r21
	ret

#ifdef SMVM_EEPROM
read:
	sbrc r31, 7
	rjmp read_eeprom
	lpm r0, Z+
	ret
read_eeprom:                              ; the next byte to r0
	sbic _SFR_IO_ADDR(EECR), EEPE
	rjmp read_eeprom
	andi r31, 0x7F
	out _SFR_IO_ADDR(EEARH), r31
	out _SFR_IO_ADDR(EEARL), r30
	ori r31, 0x80
	sbi _SFR_IO_ADDR(EECR), EERE
	in r0, _SFR_IO_ADDR(EEDR)
	adiw r30, 1
	ret
#endif
#endif
