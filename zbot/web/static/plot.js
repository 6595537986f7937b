// Curves that grow in the browser: the server sends only what is new.
"use strict";
