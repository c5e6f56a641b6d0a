"""gearlash: where a gear pair with backlash runs quietly, where teeth hit, and where one turns into the other."""
