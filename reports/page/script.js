(function () {
  'use strict';
  function list(nodes) { return Array.prototype.slice.call(nodes); }

  // The address's fragment holds a place and the target: "#s2&target=0.5-cosine".
  function fragment() {
    var words = location.hash.slice(1).split('&'), found = {place: '', target: ''};
    words.forEach(function (word) {
      if (word.indexOf('target=') === 0) found.target = word.slice(7);
      else if (word) found.place = word;
    });
    return found;
  }

  function remember(place, target) {
    try { history.replaceState(null, '', '#' + (place ? place + '&' : '') + 'target=' + target); } catch (e) {}
  }

  // One target at a time, in all sections. Without a control there is nothing to choose.
  var control = document.getElementById('targets'), target = '';
  function choose(slug) {
    target = slug;
    list(document.querySelectorAll('[data-target]')).forEach(function (part) {
      part.hidden = part.getAttribute('data-target') !== slug;
    });
  }
  function follow() {
    var wish = fragment(), radios = list(control.querySelectorAll('input'));
    var known = radios.some(function (radio) { return radio.value === wish.target; });
    if (known) choose(wish.target);
    else if (!target) choose(radios[0].value);
    radios.forEach(function (radio) { radio.checked = radio.value === target; });
    remember(wish.place, target);
    var place = wish.place && document.getElementById(wish.place);
    if (place) place.scrollIntoView();
  }
  if (control) {
    control.hidden = false;
    control.addEventListener('change', function (event) {
      choose(event.target.value);
      remember(fragment().place, target);
    });
    window.addEventListener('hashchange', follow);
    follow();
  }

  // Sorts by data-v where there is one, else by text; cells without a value stay below.
  function value(row, i) {
    var cell = row.cells[i], v = cell.getAttribute('data-v');
    if (v !== null) return parseFloat(v);
    return cell.className === 'n' ? null : cell.textContent;
  }
  function compare(a, b) {
    return typeof a === 'number' ? a - b : a.localeCompare(b, undefined, {numeric: true});
  }
  function sort(table, th) {
    var i = th.cellIndex, up = th.getAttribute('aria-sort') !== 'ascending', body = table.tBodies[0];
    list(th.parentNode.cells).forEach(function (cell) { cell.removeAttribute('aria-sort'); });
    th.setAttribute('aria-sort', up ? 'ascending' : 'descending');
    list(body.rows).sort(function (p, q) {
      var a = value(p, i), b = value(q, i);
      if (a === null || b === null) return (a === null) - (b === null);
      return up ? compare(a, b) : compare(b, a);
    }).forEach(function (row) { body.appendChild(row); });
  }

  // The words of the filter hold for the tables of all targets; the count is that of the one in sight.
  var filter = document.getElementById('filter'), tables = list(document.querySelectorAll('table.cases'));
  function show() {
    var words = filter.value.toLowerCase().split(/\s+/), hits = 0, all = 0;
    tables.forEach(function (table) {
      var seen = !table.closest('[hidden]');
      list(table.tBodies[0].rows).forEach(function (row) {
        var text = row.textContent.toLowerCase();
        row.hidden = !words.every(function (word) { return text.indexOf(word) >= 0; });
        all += seen;
        hits += seen && !row.hidden;
      });
    });
    document.getElementById('shown').textContent = hits + ' of ' + all;
  }
  tables.forEach(function (table) {
    list(table.tHead.rows[0].cells).forEach(function (th) {
      th.querySelector('button').addEventListener('click', function () { sort(table, th); });
    });
  });
  filter.addEventListener('input', show);
  if (control) control.addEventListener('change', show);
  show();
})();
