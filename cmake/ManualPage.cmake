# Writes the manual page of the program: a template with what `breccia COMMAND --help` says of every command.
#
#   cmake -D PROGRAM=[emulator;]breccia -D VERSION=0.1.0 -D TEMPLATE=breccia.1.in -D OUTPUT=breccia.1 -P ManualPage.cmake

# help_of(VARIABLE ARGUMENT...): what the program prints.
function(help_of variable)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

help_of(overview --help)
string(REGEX REPLACE ".*\nCommands:\n" "\n" list "${overview}")
string(REGEX MATCHALL "\n  [a-z]+ " commands "${list}")

set(COMMANDS "")
foreach(command IN LISTS commands)
  string(STRIP "${command}" command)
  help_of(text ${command} --help)
  string(REGEX REPLACE "\nA deck to begin with:[^\n]*" "" text "${text}")  # stands under FILES
  string(REPLACE "\\" "\\e" text "${text}")
  string(REPLACE "-" "\\-" text "${text}")
  # An option or an argument, two or more spaces or a new line, what it means.
  string(REGEX REPLACE "\n  (([^ \n]+ )*[^ \n]+)[ \n] +([^\n]+)" "\n.TP\n.B \\1\n\\3" text "${text}")
  string(REGEX REPLACE "\nUsage: ([^\n]+)" "\n.PP\n.B \\1" text "${text}")
  string(REGEX REPLACE "\n(Arguments|Options):" "" text "${text}")
  string(REGEX REPLACE "\n\n+" "\n.PP\n" text "${text}")
  string(REGEX REPLACE "\n(.PP\n)+.TP" "\n.TP" text "${text}")
  string(REGEX REPLACE "(\n|.PP)+$" "" text "${text}")
  string(APPEND COMMANDS ".SS breccia ${command}\n${text}\n")
endforeach()
configure_file("${TEMPLATE}" "${OUTPUT}" @ONLY)
