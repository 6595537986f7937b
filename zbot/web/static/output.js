// Output of a process. If the user has scrolled up, the view stays there.
"use strict";
zbot.showOutput = (id, text) => {
  const place = getHtmlElement(id);
  if (!place) return;
  const isAtEnd = place.scrollHeight - place.scrollTop - place.clientHeight < 20;
  place.textContent = text;
  if (isAtEnd) place.scrollTop = place.scrollHeight;
};
