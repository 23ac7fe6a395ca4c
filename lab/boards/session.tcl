# What OpenOCD does with a chip, in its own language; session.py puts the procedures in order. Every step
# is told by a line that begins with "turnbuckle", and the first error ends the session.

proc turnbuckle_connect {register identity size_register bytes option_register} {
    echo "turnbuckle step connect"
    set found [expr {[read_memory $register 32 1] & 0xFFF}]
    if {$found != $identity} { turnbuckle_refuse [format "chip 0x%03x" $found] }
    set protection [expr {[read_memory $option_register 32 1] & 0xFF}]
    if {$protection == 0xCC} { turnbuckle_refuse "sealed" }
    if {$protection != 0xAA} { turnbuckle_refuse "locked" }
    set kilobytes [expr {[read_memory $size_register 32 1] & 0xFFFF}]
    if {$kilobytes * 1024 < $bytes} { turnbuckle_refuse "size $kilobytes" }
    reset halt
}

proc turnbuckle_refuse {words} {
    echo "turnbuckle refused $words"
    shutdown error
    error $words
}

proc turnbuckle_look {file begin bytes} {
    echo "turnbuckle step look"
    dump_image $file $begin $bytes
}

# The first page last: a chip whose power goes before that has no program to start.
proc turnbuckle_program {file head rest begin bytes page} {
    echo "turnbuckle step erase"
    flash erase_address pad $begin $bytes
    echo "turnbuckle step write"
    if {$bytes > $page} { flash write_bank 0 $rest $page }
    flash write_bank 0 $head 0
    echo "turnbuckle step verify"
    verify_image $file $begin bin
}

proc turnbuckle_start {} {
    echo "turnbuckle step start"
    reset run
    echo "turnbuckle done"
}
