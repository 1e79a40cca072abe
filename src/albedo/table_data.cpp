// The file inversion.table, as `nacre albedo build` writes it, inside the program.
asm(".section .rodata\n"
    ".balign 4\n"
    ".global nacre_albedo_table_begin, nacre_albedo_table_end\n"
    "nacre_albedo_table_begin:\n"
    ".incbin \"" NACRE_ALBEDO_TABLE "\"\n"
    "nacre_albedo_table_end:\n"
    ".previous\n");
