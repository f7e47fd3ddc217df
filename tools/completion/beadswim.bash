# Bash completion for the programs of Beadswim: completes subcommands, flags and the values of flags, as --help lists them.

# Prints the help of the program and of the subcommands that stand before the cursor.
_beadswim_help() {
  local -a command=("${COMP_WORDS[0]}")
  local word
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    [[ $word == [a-z]* ]] && "${command[@]}" --help 2>/dev/null | grep -qx "  $word" && command+=("$word")
  done
  "${command[@]}" --help 2>/dev/null
}

_beadswim() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} help flag words
  # Bash splits --flag=value into three words: the flag, "=" and the value.
  [[ $current == = ]] && current=
  [[ $previous == = ]] && previous=${COMP_WORDS[COMP_CWORD - 2]}
  help=$(_beadswim_help)
  flag=$(grep -E "^  ([^ ]+,)?${previous}( |$)" <<<"$help" 2>/dev/null)
  if [[ $previous == -* && $flag == *" "*[A-Za-z]* && ${flag##* } != "$flag" && ${flag##* } != -* ]]; then
    words=${flag##* } # values of the flag in the help: words such as a|b|c, or a name in capitals
    words=${words%%:*}
    if [[ $words == *"|"* && $words != *[A-Z]* ]]; then
      mapfile -t COMPREPLY < <(compgen -W "${words//|/ }" -- "$current")
    else
      mapfile -t COMPREPLY < <(compgen -f -- "$current")
    fi
  elif [[ $current == -* ]]; then
    words=$(grep -oE '^  (-[a-zA-Z],)?--[a-z-]+' <<<"$help" | grep -oE -- '--[a-z-]+')
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  else
    words=$(sed -n '/^Subcommands:/,$p' <<<"$help" | grep -oE '^  [a-z-]+$')
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current"; compgen -f -- "$current")
  fi
}

complete -o filenames -F _beadswim beadswim-layout beadswim-run beadswim-theory beadswim-compare beadswim-optimise beadswim-plot beadswim-view beadswim-bench
