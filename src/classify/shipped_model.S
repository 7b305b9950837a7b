/* The model that comes with RVA, and its card, as bytes of the library: it works wherever the library is,
   without a file that may be missing. The build defines MODEL_FILE and CARD_FILE. */
    .section .rodata
    .global rva_shipped_model, rva_shipped_model_end, rva_shipped_card, rva_shipped_card_end
    .balign 16
rva_shipped_model:
    .incbin MODEL_FILE
rva_shipped_model_end:
    .byte 0
rva_shipped_card:
    .incbin CARD_FILE
rva_shipped_card_end:
    .byte 0
    .section .note.GNU-stack, "", %progbits
