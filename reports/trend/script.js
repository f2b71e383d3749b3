// Behind the script of reports/page, which sorts and filters the table of changes.
(function () {
  'use strict';
  function list(nodes) { return Array.prototype.slice.call(nodes); }
  var filter = document.getElementById('filter'), count = document.getElementById('charts');
  var groups = list(document.querySelectorAll('section.group')).reverse();

  // A chart is found by its own words and by those of the headings above it.
  var charts = list(document.querySelectorAll('figure.series')).map(function (figure) {
    var text = figure.textContent, at = figure;
    while ((at = at.parentNode.closest('section.group'))) text += ' ' + at.firstElementChild.textContent;
    return {figure: figure, text: text.toLowerCase()};
  });

  // The address's fragment holds a place and the filter: "#l12&q=gtao%20vulkan".
  function fragment() {
    var found = {place: '', q: null};
    location.hash.slice(1).split('&').forEach(function (word) {
      try {
        if (word.indexOf('q=') === 0) found.q = decodeURIComponent(word.slice(2));
        else if (word) found.place = word;
      } catch (e) {}
    });
    return found;
  }
  function remember(place) {
    var q = filter.value ? 'q=' + encodeURIComponent(filter.value) : '';
    try {
      history.replaceState(null, '', '#' + place + (place && q ? '&' : '') + q);
    } catch (e) {}
  }

  function show() {
    var words = filter.value.toLowerCase().split(/\s+/), hits = 0;
    charts.forEach(function (chart) {
      var hit = words.every(function (word) { return chart.text.indexOf(word) >= 0; });
      chart.figure.hidden = !hit;
      hits += hit;
    });
    groups.forEach(function (group) {
      group.hidden = !group.querySelector('figure.series:not([hidden])');
    });
    count.textContent = hits === charts.length ? hits : hits + ' of ' + charts.length;
  }
  function set(words) {
    if (filter.value === words) return;
    filter.value = words;
    filter.dispatchEvent(new Event('input'));
  }
  // A link to a chart that the filter hides ends the filter.
  function follow() {
    var wish = fragment();
    if (wish.q !== null) set(wish.q);
    var place = wish.place && document.getElementById(wish.place);
    if (place && place.hidden) set('');
    remember(wish.place);
    if (place) place.scrollIntoView();
  }
  document.getElementById('tools').hidden = false;
  filter.addEventListener('input', function () {
    show();
    remember('');
  });
  window.addEventListener('hashchange', follow);
  if (location.hash) follow();
})();
