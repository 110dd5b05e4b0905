// An attempt that a link leads to is shown unfolded.
function unfold() {
  const found = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (found && found.tagName === "DETAILS") {
    found.open = true;
    found.querySelector("summary").focus();
  }
}
addEventListener("hashchange", unfold);
document.addEventListener("click", (event) => {
  const link = event.target.closest("a[href^='#a-']");
  if (link && link.hash === location.hash) unfold();
});
unfold();
