# Of release builds, for what is shipped: a stack that was written past its end and a buffer whose size is known end the
# program, and its addresses cannot be foreseen. What it costs stands in SECURITY.md. Sanitizers have checks of their
# own, which these would hide.
if(NOT TIMESHADE_SANITIZE)
  set(TIMESHADE_HARDENING
    $<$<CONFIG:Release>:-fstack-protector-strong> $<$<CONFIG:Release>:-U_FORTIFY_SOURCE>
    $<$<CONFIG:Release>:-D_FORTIFY_SOURCE=3> $<$<CONFIG:Release>:-fPIE>)
endif()
