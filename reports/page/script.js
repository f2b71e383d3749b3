(function(){
var table=document.getElementById('table'),body=table.tBodies[0],filter=document.getElementById('filter');
var rows=Array.prototype.slice.call(body.rows);
function value(row,i){var c=row.cells[i],v=c.getAttribute('data-v');
 if(v!==null)return parseFloat(v);
 return c.className==='n'?null:c.textContent;}
function compare(a,b){if(typeof a==='number')return a-b;return a.localeCompare(b,undefined,{numeric:true});}
function sort(th){var i=th.cellIndex,up=th.getAttribute('aria-sort')!=='ascending';
 Array.prototype.forEach.call(th.parentNode.cells,function(c){c.removeAttribute('aria-sort');});
 th.setAttribute('aria-sort',up?'ascending':'descending');
 rows.sort(function(p,q){var a=value(p,i),b=value(q,i);
  if(a===null||b===null)return (a===null)-(b===null);
  return up?compare(a,b):compare(b,a);});
 rows.forEach(function(r){body.appendChild(r);});}
function show(){var words=filter.value.toLowerCase().split(/\s+/),n=0;
 rows.forEach(function(r){var t=r.textContent.toLowerCase();
  var hit=words.every(function(w){return t.indexOf(w)>=0;});r.hidden=!hit;n+=hit;});
 document.getElementById('shown').textContent=n+' of '+rows.length;}
Array.prototype.forEach.call(table.tHead.rows[0].cells,function(th){
 th.querySelector('button').addEventListener('click',function(){sort(th);});});
filter.addEventListener('input',show);show();
})();
