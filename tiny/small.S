# The tracer of tiny.c as a whole executable for Linux on x86-64 with SSE4.1, in single precision. README.md explains it.
        .intel_syntax noprefix
        .globl  _start
        .equ    base, 0x3b000000        # bits of 2^-9 as a float, so that a pointer into here is about that

_start:                                 # at `base`
        .byte   0x7f, 'E', 'L', 'F'
step:   .byte   -52, 0, 39, 0           # the unused rest of e_ident: a pixel to the left,
        .byte   -15, 60, -20, 0         # one up,
        .byte   -5, -110, -115, 0       # and the lower right corner of the picture, from
        .short  2, 62                   # e_type, e_machine
eye:    .byte   8, 4, 9, 1              # e_version
        .quad   begin                   # e_entry
        .quad   program - _start        # e_phoff
lamp:   .byte   80, 80, 48, 1, 6, 7, 1  # e_shoff, e_flags, e_ehsize: colors, places
        .byte   48, 48, 80, 8, 4, 6, 1
lamps:  .short  56                      # e_phentsize
program:.long   1                       # e_phnum and e_shentsize; p_type
none:   .long   7                       # e_shnum, e_shstrndx; p_flags
        .quad   0                       # p_offset: the black color of rays that meet nothing
        .quad   base                    # p_vaddr
pixel:  .long   0, 1024                 # p_paddr: twice the column, from the right, and twice the row, from below
        .quad   511                     # p_filesz, p_memsz: half a picture
        .quad   511
#       Twice b, c - a, color, reflectance in quarters, twice a. The first eight bytes are p_align as well.
shapes: .byte   0, 2, 0, 0,      6, 6, 6, 1,  0
        .byte   0, 0, 2, 0,      1, 2, 2, 2,  0
        .byte   2, 0, 0, 0,      6, 4, 2, 0,  0
        .byte   0, 0, -2, 20,    4, 4, 4, 0,  0
        .byte   -2, 0, 0, 20,    2, 4, 6, 0,  0
        .byte   -4, -2, -6, 12,  7, 2, 1, 0,  2
        .byte   -8, -2, -10, 40, 1, 1, 1, 3,  2
        .byte   -22, -2, -18, 99, 2, 6, 2, 1, 4
        .equ    size, 9
head:   .ascii  "P6 512 512 255\n"

        .equ    end_of_lamps, lamps - _start
#       From rbx, which is `none`.
        .equ    to_step, step - none
        .equ    to_eye, eye - none
        .equ    to_lamp, lamp - none
        .equ    to_pixel, pixel - none
        .equ    to_shapes, shapes - none
        .equ    to_head, head - none

        .macro  load to, from           # four bytes as floats
        pmovsxbd \to, [\from]
        cvtdq2ps \to, \to
        .endm

begin:  mov     ebx, offset none
        lea     esi, [rbx + to_head]
        push    15
        pop     rdx
        jmp     write

next:   lea     esi, [rbx + to_step]
        cvtdq2ps xmm2, [rbx + to_pixel]
        xorps   xmm1, xmm1
        push    3
        pop     rcx
axis:   load    xmm3, rsi               # d = x left + y up + 511 corner
        pshufd  xmm4, xmm2, 0
        mulps   xmm3, xmm4
        addps   xmm1, xmm3
        psrldq  xmm2, 4
        add     esi, 4
        loop    axis
        load    xmm0, "rbx + to_eye"
        movd    xmm7, ebx               # c, half a level when four times doubled twice
        shufps  xmm7, xmm7, 0
        movaps  xmm8, xmm7              # w
        push    4
        pop     r8

hop:    addps   xmm7, xmm7
        addps   xmm7, xmm7
        call    trace
        movd    xmm4, ebp               # o += t d
        shufps  xmm4, xmm4, 0
        mulps   xmm4, xmm1
        addps   xmm0, xmm4
        mov     esi, edi
        call    normal
        insertps xmm5, xmm5, 8          # n, without what is not of space
        movaps  xmm9, xmm5
        lea     eax, [rbx + to_shapes]
        cmp     eax, edi
        jne     plain
        cvttps2dq xmm4, xmm0            # the floor: is the sum of its whole coordinates odd?
        pslld   xmm4, 31
        movmskps eax, xmm4              # w is 1, y is 0
        test    al, al
        jp      dark
        jmp     plain
dark:   add     esi, size
plain:  load    xmm6, "rsi + 4"
        mulps   xmm6, xmm8
        movaps  xmm10, xmm6             # w f
        shufps  xmm6, xmm6, 0xff
        movaps  xmm8, xmm6              # w times the reflectance
        dpps    xmm5, xmm1, 0xff        # d = 2 d - (n . d) n, where n has the length 2
        mulps   xmm5, xmm9
        addps   xmm1, xmm1
        subps   xmm1, xmm5
        movaps  xmm11, xmm1
        lea     edx, [rbx + to_lamp]
light:  load    xmm1, "rdx + 3"
        subps   xmm1, xmm0              # l
        call    trace
        cmp     edi, ebx
        jne     shadow
        sqrtps  xmm4, xmm2
        dpps    xmm1, xmm9, 0xff
        divps   xmm1, xmm4
        maxps   xmm1, xmm15             # 0
        mulps   xmm1, xmm10
        load    xmm4, rdx
        mulps   xmm1, xmm4
        addps   xmm7, xmm1
shadow: add     edx, 7
        cmp     dl, end_of_lamps
        jne     light
        movaps  xmm1, xmm11
        dec     r8d
        jnz     hop

        cvttps2dq xmm7, xmm7
        packusdw xmm7, xmm7
        packuswb xmm7, xmm7
        movd    [rsp], xmm7
        push    rsp
        pop     rsi
        push    3
        pop     rdx
write:  push    1
        pop     rdi
        mov     eax, edi
        syscall
        sub     dword ptr [rbx + to_pixel], 2
        jns     next
        mov     dword ptr [rbx + to_pixel], 1022
        sub     dword ptr [rbx + to_pixel + 4], 2
        jns     next
        push    60
        pop     rax
        xor     edi, edi
        syscall

# What the ray xmm0 + t xmm1 meets first, to edi, and t, to ebp; none: edi = ebx, t = 1.
trace:  push    8
        pop     rcx
        lea     esi, [rbx + to_shapes]
        mov     edi, ebx
        mov     ebp, 0x3f800000
        movaps  xmm2, xmm1
        dpps    xmm2, xmm1, 0xff        # d . d
shape:  call    normal
        addps   xmm3, xmm5
        dpps    xmm3, xmm0, 0xff        # C = f(o)
        dpps    xmm5, xmm1, 0xff        # e = n . d, at most 0
        minps   xmm5, xmm15
        mulps   xmm4, xmm3
        mulps   xmm4, xmm2
        movaps  xmm6, xmm5
        mulps   xmm6, xmm6
        subps   xmm6, xmm4
        sqrtps  xmm6, xmm6
        subps   xmm6, xmm5
        divps   xmm3, xmm6              # t = C / (sqrt(e e - a d.d C) - e)
        movd    eax, xmm3
        cmp     eax, ebp                # unsigned: negative ones and NaN are larger than all
        jae     farther
        xchg    eax, ebp
        mov     edi, esi
farther:add     esi, size
        loop    shape
        ret

normal: load    xmm3, rsi               # b
        movsx   eax, byte ptr [rsi + 8]
        cvtsi2ss xmm4, eax
        shufps  xmm4, xmm4, 0           # a
        movaps  xmm5, xmm4
        mulps   xmm5, xmm0
        addps   xmm5, xmm3              # n = a o + b
        ret
